#include "tests/solver/solver_test.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/solver/fluid/fluid_grid.h"
#include "tests/pair_fixture.h"

namespace knuckle::test {

TempFolder& shaderFolder()
{
    static TempFolder folder;
    return folder;
}

Gpu& gpu()
{
    static Gpu gpu({}, shaderFolder().path());
    return gpu;
}

Vector3f Random::direction()
{
    for (;;) {
        const Vector3f v = inCube(1.0f);
        if (v.norm() > 0.1f && v.norm() < 1.0f) return v.normalized();
    }
}

Quaternionf Random::rotation()
{
    const float angle = between(0.0f, std::numbers::pi_v<float>);
    return Quaternionf(Eigen::AngleAxisf(angle, direction()));
}

namespace {

void addOne(WorldBuilder& builder, const Eigen::Vector3i& counts, const Pose& pose, Motion motion = Motion::Dynamic)
{
    builder.beginObject("body");
    builder.addBody("body", boxLattice(counts, DIAMETER), 0, motion);
    builder.endObject(pose);
}

void addPair(WorldBuilder& builder, JointType type, float apart, const Pose& pose, Motion motionOfA = Motion::Dynamic)
{
    PairSpec pair;
    pair.joint.type = type;
    pair.joint.limitSide = 1;
    pair.apart = apart;
    pair.materialOfB = 1;
    pair.motionOfA = motionOfA;
    pair.selfMargin = apart < 3.0f ? 0.5f : 0.0f;  // for the pair that overlaps
    addJointedPair(builder, pair, pose);
}

}  // namespace

World mixedWorld(const Settings& settings, uint32_t particleCount)
{
    WorldBuilder builder(DIAMETER / 2, settings);
    Material light, heavy;
    light.density = 700.0f;
    heavy.density = 2400.0f;
    builder.addMaterial(light);
    builder.addMaterial(heavy);
    Random random(7);
    const auto pose = [&] { return Pose{random.inCube(0.4f), random.rotation()}; };
    for (JointType type : {JointType::Ball, JointType::Hinge, JointType::Stiff, JointType::Universal})
        addPair(builder, type, 4.0f, pose());
    addPair(builder, JointType::Ball, 1.5f, pose());  // overlaps itself at rest
    addPair(builder, JointType::Hinge, 4.0f, pose(), Motion::Fixed);
    for (const Eigen::Vector3i& counts : {Eigen::Vector3i(5, 1, 4), {6, 1, 1}, {9, 3, 3}, {1, 1, 1}})
        addOne(builder, counts, pose());
    addOne(builder, {4, 2, 3}, pose(), Motion::Fixed);
    while (builder.particleCount() < particleCount) {
        Particle grain;
        grain.position = grain.restPosition = random.inCube(0.5f);
        grain.velocity = random.inCube(1.0f);
        builder.addLooseParticle(grain);
    }
    return builder.build();
}

Settings byThePaper()
{
    Settings settings;
    settings.solver = SolverKind::Paper;
    return settings;
}

Kernel KernelFixture::load(const std::string& name, const Defines& defines)
{
    Defines all = defines;
    all.insert(all.end(), {{"BOX_REGIONS", "1"}, {"ROUND_REGIONS", "1"}});
    return Kernel(gpu(), stages.table(), "sim/" + name + ".comp", all, {}, gridRenames(defines));
}

void KernelFixture::run(const std::string& name, uint64_t threads, const Defines& defines)
{
    dispatch(load(name, defines), groupsFor(threads));
    gpu().checkErrors();
}

void KernelFixture::forParticles(const std::string& name, const Defines& defines)
{
    run(name, stages.parameters.particleCount, defines);
}

void KernelFixture::forBodies(const std::string& name, const Defines& defines)
{
    run(name, stages.parameters.bodyCount, defines);
}

void KernelFixture::forMovers(const std::string& name, const Defines& defines)
{
    run(name, stages.parameters.moverCount, defines);
}

void KernelFixture::setFound(const std::vector<gpu::vec4>& places)
{
    fill(stages.search.searchPositions, places);
    // Other results of search_position besides the places.
    auto counts = stages.search.listCounts.download();
    const uint32_t count = stages.parameters.particleCount;
    std::fill(counts.begin() + count, counts.begin() + 2 * count, 0u);
    fill(stages.search.listCounts, counts);
    gpu::Counters now = counters();
    now.candidateCount = 0;
    setCounters(now);
}

void KernelFixture::fillGrid(const Defines& defines)
{
    const uint32_t cells = stages.parameters.cellMask + 1;
    forParticles("common/grid/grid_count", defines);
    run("common/grid/scan_sum", cells / SCAN_CHUNK);
    run("common/grid/grid_start", cells / SCAN_CHUNK);
    forParticles("common/grid/grid_scatter");
    forParticles("search/grid_order");
}

void KernelFixture::findPairs(GridKind grid)
{
    Defines defines = gridDefines(grid);
    fillGrid(defines);
    if (std::ranges::any_of(world.bodies, [](const Body& body) { return !body.filtered.empty(); }))
        defines.push_back({"FILTERS", "1"});
    forParticles("search/contact_find", defines);
    run("search/contact_find_far", counters().fastListed, defines);
}

void KernelFixture::fillLists()
{
    const Defines lists = {{"LISTS", "1"}};
    const uint32_t chunks = 3 * stages.parameters.particleCount / SCAN_CHUNK + 1;
    run("common/grid/scan_sum", chunks, lists);
    run("search/list_start", chunks, lists);
    run("search/pair_list", std::max(counters().candidateCount, 1u));
    run("contact/contact_prepare", counters().pairCount);
    run("contact/collider_prepare", counters().colliderPairCount);
}

void KernelFixture::turnHalves()
{
    gpu::Counters now = counters();
    now.listParity ^= 1u;
    setCounters(now);
}

Defines gridDefines(GridKind kind)
{
    return kind == GridKind::Hash ? Defines{{"GRID_HASH", "1"}} : Defines{};
}

Collider planeAt(const Vector3f& place, const Vector3f& normal)
{
    Collider collider;
    collider.shape = ColliderShape::Plane;
    collider.position = place;
    collider.orientation = Quaternionf::FromTwoVectors(Vector3f::UnitY(), normal);
    return collider;
}

std::string gridName(const testing::TestParamInfo<GridKind>& kind)
{
    return kind.param == GridKind::Hash ? "Hash" : "Lattice";
}

std::vector<gpu::vec4> randomVectors(size_t count, float half, uint32_t seed)
{
    Random random(seed);
    std::vector<gpu::vec4> values(count);
    for (gpu::vec4& v : values) v = random.vec4(half);
    return values;
}

}  // namespace knuckle::test
