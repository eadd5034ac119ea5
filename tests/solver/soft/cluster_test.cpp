#include <algorithm>

#include "sim/solver/layout/cluster_links.h"
#include "sim/solver/layout/soft_pace.h"
#include "tests/solver/body/mover_fixture.h"

namespace knuckle::test {

namespace {

/// Soft bodies that are solid, even, flat, straight, round and plastic, among other things: no number of clusters or
/// particles is a multiple of a group.
World softWorld()
{
    WorldBuilder builder(DIAMETER / 2);
    Material firm, plastic;
    firm.elasticity.poissonRatio = 0.4f;
    plastic.density = 1700.0f;
    plastic.elasticity = {2e4f, 0.1f, 0.02f, 0.05f, 30.0f, 0.4f};
    builder.addMaterial(firm);
    builder.addMaterial(plastic);
    Random random(5);
    const auto add = [&](const std::vector<Vector3f>& positions, uint32_t material, bool soft) {
        builder.beginObject("thing");
        if (soft) builder.addSoftBody("soft", positions, material);
        else builder.addBody("rigid", positions, material);
        builder.endObject({random.inCube(2.0f), random.rotation()});
    };
    add(boxLattice({11, 7, 5}, DIAMETER), 0, true);
    add(boxLattice({3, 3, 3}, DIAMETER), 0, false);
    add(boxLattice({4, 6, 3}, DIAMETER), 1, true);
    builder.addLooseParticle({});
    add(boxLattice({5, 1, 4}, DIAMETER), 0, true);
    add(boxLattice({1, 7, 1}, DIAMETER), 0, true);
    add(sphereLattice(0.25f, DIAMETER), 1, true);
    add(boxLattice({1, 1, 1}, DIAMETER), 0, true);
    return builder.build();
}

Matrix3d columns(const std::vector<gpu::vec4>& values, size_t first)
{
    Matrix3d out;
    for (int k = 0; k < 3; ++k) out.col(k) = vec3(values[first + static_cast<size_t>(k)]).cast<double>();
    return out;
}

/// Expected results of the kernels for a cluster, in double precision.
struct Wanted {
    Matrix3d map, rotation, strain, pull;
    Vector3d centre;
    double grip = 0.0, factor = 0.0;  // Chebyshev's, of the first iteration
};

class ClusterKernels : public testing::Test {
protected:
    ClusterKernels() : fixture(softWorld()), places(fixture.stages.particles.particleRanks.download())
    {
        for (const SoftBody& soft : fixture.world.softBodies) paces.push_back(softPace(fixture.world, soft));
        Random random(11);
        auto starts = fixture.stages.bodies.moverCentres.download(),
             moveValues = fixture.stages.bodies.moverMoves.download();
        auto rests = fixture.stages.soft->clusterRests.download();
        for (const SoftBody& soft : fixture.world.softBodies)
            for (uint32_t i = soft.particleStart; i < soft.particleStart + soft.particleCount; ++i) {
                gpu::vec4& start = starts[places[i].x];
                start = packed(Vector3f(vec3(start) + random.inCube(0.15f * DIAMETER)));
                moveValues[places[i].x] = packed(random.inCube(0.02f * DIAMETER), 3.0f);
            }
        for (uint32_t c = 0; c < fixture.world.clusters.size(); ++c) {
            if (fixture.world.softBodies[fixture.world.clusters[c].softBody].material == 0) continue;
            Matrix3d rest = Matrix3d::Identity() + 0.1 * Matrix3d(random.rotation().cast<double>());
            rest /= std::cbrt(rest.determinant());
            for (uint32_t k = 0; k < 3; ++k) rests[3 * c + k] = packed(Vector3f(rest.col(k).cast<float>()));
        }
        fill(fixture.stages.bodies.moverCentres, starts);
        fill(fixture.stages.bodies.moverMoves, moveValues);
        fill(fixture.stages.soft->clusterRests, rests);
        auto states = fixture.stages.particles.assemblyState.download();
        states[fixture.world.softBodies[0].assembly].y = 2;  // BDF2 in this one
        fill(fixture.stages.particles.assemblyState, states);
        centres = starts;
        moves = moveValues;
        restsBefore = rests;
    }

    Vector3d start(uint32_t particle) const { return vec3(centres[places[particle].x]).cast<double>(); }
    Vector3d place(uint32_t particle) const { return start(particle) + vec3(moves[places[particle].x]).cast<double>(); }
    float timeShare(uint32_t softBody) const { return softBody == 0 ? 4.0f / 9.0f : 1.0f; }

    Wanted wanted(uint32_t c) const
    {
        const World& world = fixture.world;
        const Cluster& cluster = world.clusters[c];
        const Material& material = world.materials[world.softBodies[cluster.softBody].material];
        const ClusterMoments m = clusterMoments(world, cluster);
        Wanted out;
        Matrix3d now = Matrix3d::Zero(), before = Matrix3d::Zero();
        out.centre.setZero();
        const Vector3d origin = start(world.clusterLinks[cluster.linkStart + cluster.linkCount / 2].particle);
        for (uint32_t l = cluster.linkStart; l < cluster.linkStart + cluster.linkCount; ++l) {
            const Link& link = world.clusterLinks[l];
            const Vector3d r = link.restOffset.cast<double>();
            out.centre += link.mass * place(link.particle) / m.mass;
            now += link.mass * (place(link.particle) - origin) * r.transpose();
            before += link.mass * (start(link.particle) - origin) * r.transpose();
        }
        out.map = now * m.inverse;
        const Matrix3d rest = columns(restsBefore, 3 * c), elastic = out.map * rest.inverse();
        out.rotation = nearestRotation(elastic).toRotationMatrix();
        const Matrix3d stretch = out.rotation.transpose() * elastic + m.empty;
        out.strain = 0.5 * (stretch + stretch.transpose()) - Matrix3d::Identity();
        const Elasticity& e = material.elasticity;
        const SoftPace& pace = paces[cluster.softBody];
        const double shear = pace.stiffness / (1.0 + e.poissonRatio) / material.density;
        const double dilation = shear * e.poissonRatio / (1.0 - 2.0 * e.poissonRatio);
        const auto hooke = [&](const Matrix3d& strain) -> Matrix3d {
            return shear * strain + dilation * strain.trace() * Matrix3d::Identity();
        };
        const Matrix3d mapBefore = before * m.inverse;
        const Matrix3d rate = 0.5 * (out.map.transpose() * out.map - mapBefore.transpose() * mapBefore);
        const double h = fixture.stages.parameters.substepTime, share = timeShare(cluster.softBody);
        const Matrix3d squares = out.map.transpose() * out.map;
        const double drawnOut = std::max(1.0, squares.cwiseAbs().rowwise().sum().maxCoeff());
        const Matrix3d stress = share * h * h * out.rotation * hooke(out.strain) * rest.inverse().transpose() +
                                share * h * pace.damping / drawnOut * out.map * hooke(rate);
        out.grip = share * h * h * pace.stiffness / material.density * m.bending;
        const Chebyshev chebyshev(pace.iterations);
        // The eigenvalues taken are from least to most; their mean divides. The smallest root of n is at 1, or above.
        const double most = 1.0 + share * h * (h + pace.damping) * pace.steepest;
        const double cosine = chebyshev.cosine;
        const double least = std::max((2.0 - most * (1.0 - cosine)) / (1.0 + cosine), chebyshev.least * most);
        out.factor = 2.0 / (least + most);
        out.pull = out.grip * out.map - m.mass * stress * m.inverse;
        return out;
    }
    void match()
    {
        const Kernel kernel = fixture.load("soft/cluster_match", {{"FIRST_ITERATION", "1"}});
        glProgramUniform4ui(kernel.program(), 0, 0, 2, 0, fixture.stages.parameters.clusterCount);
        fixture.dispatch(kernel, groupsFor(fixture.world.clusters.size()));
        gpu().checkErrors();
    }
    void pull()
    {
        const Kernel kernel = fixture.load("soft/cluster_pull", {{"FIRST_ITERATION", "1"}});
        const uint32_t count = fixture.stages.parameters.softCount;
        glProgramUniform2ui(kernel.program(), 0, 0, count);
        fixture.dispatch(kernel, groupsFor(count));
        gpu().checkErrors();
    }

    KernelFixture fixture;
    std::vector<gpu::uvec2> places;
    std::vector<gpu::vec4> centres, moves, restsBefore;
    std::vector<SoftPace> paces;
};

TEST_F(ClusterKernels, AClusterIsMatchedAndPullsAsTheReferenceSays)
{
    match();
    const auto pulls = fixture.stages.soft->clusterPulls.download(),
               rotations = fixture.stages.soft->clusterRotations.download();
    ASSERT_GT(fixture.world.clusters.size(), 40u);
    for (uint32_t c = 0; c < fixture.world.clusters.size(); ++c) {
        SCOPED_TRACE("cluster " + std::to_string(c));
        const Wanted w = wanted(c);
        // Rotations to 1e-5 (rotation_test.cpp); a line's twist is undetermined, but R times its only direction is not.
        const Matrix3d rotation = quaternion(rotations[c]).cast<double>().toRotationMatrix();
        EXPECT_LT(((rotation - w.rotation) * w.map.transpose()).norm(), 2e-5 * w.map.norm());
        const Vector3d centre = (vec3(pulls[5 * c]) + vec3(pulls[5 * c + 1])).cast<double>();
        EXPECT_LT((centre - w.centre).norm(), 1e-6);  // places of a few metres are rounded to 2e-7
        EXPECT_NEAR(pulls[5 * c].w, w.grip, 1e-5 * w.grip);
        EXPECT_LT((columns(pulls, 5 * c + 2) - w.pull).norm(), 1e-4 * w.pull.norm());
    }
}

TEST_F(ClusterKernels, AClusterFlowsByAShareOfWhatIsBeyondItsYield)
{
    match();
    const auto rests = fixture.stages.soft->clusterRests.download();
    uint32_t flowed = 0;
    for (uint32_t c = 0; c < fixture.world.clusters.size(); ++c) {
        const SoftBody& soft = fixture.world.softBodies[fixture.world.clusters[c].softBody];
        const Elasticity& e = fixture.world.materials[soft.material].elasticity;
        const Matrix3d before = columns(restsBefore, 3 * c), strain = wanted(c).strain;
        const double share = 1.0 - std::exp(-e.creep * fixture.stages.parameters.substepTime);
        const double beyond = std::max(1.0 - e.yield / strain.norm(), 0.0);
        Matrix3d next = before + share * beyond * strain * before;
        if (e.creep > 0.0f) next /= std::cbrt(next.determinant());
        const Matrix3d change = next - Matrix3d::Identity();
        next = Matrix3d::Identity() + std::min(1.0, e.maxDeformation / std::max(change.norm(), 1e-20)) * change;
        EXPECT_LT((columns(rests, 3 * c) - next).norm(), 1e-5) << "cluster " << c;
        flowed += e.creep > 0.0f && beyond > 0.0;
    }
    EXPECT_GT(flowed, 10u);
}

TEST_F(ClusterKernels, ParticlesGetTheImpulsesOfTheirClustersTogether)
{
    match();
    pull();
    const auto impulses = fixture.stages.bodies.particleImpulses.download();
    const auto movesNow = fixture.stages.bodies.moverMoves.download();
    std::vector<Vector3d> sums(fixture.world.particles.size(), Vector3d::Zero());
    std::vector<double> factors(sums.size()), sizes(sums.size());
    for (const Link& link : fixture.world.clusterLinks) {
        const Wanted w = wanted(link.body);
        const Vector3d p = link.mass *
                           (w.pull * link.restOffset.cast<double>() - w.grip * (place(link.particle) - w.centre));
        sums[link.particle] += p;
        sizes[link.particle] += link.mass * (w.pull.norm() * link.restOffset.norm() + w.grip * DIAMETER);
        factors[link.particle] = w.factor;
    }
    for (uint32_t i = 0; i < sums.size(); ++i) {
        SCOPED_TRACE("particle " + std::to_string(i));
        const Vector3d found = vec3(impulses[places[i].y]).cast<double>();
        EXPECT_LE((found - factors[i] * sums[i]).norm(), 2e-4 * sizes[i]);
        if (fixture.world.particles[i].body != NO_INDEX) continue;
        const Vector3d moved = (vec3(movesNow[places[i].x]) - vec3(moves[places[i].x])).cast<double>();
        EXPECT_LE((moved - found / fixture.world.particles[i].mass).norm(), 1e-8);  // moves of 2 mm round to 1e-10
        EXPECT_EQ(movesNow[places[i].x].w, moves[places[i].x].w);
    }
}

TEST_F(ClusterKernels, TheImpulsesOfABodyNeitherMoveNorTurnIt)
{
    match();
    pull();
    const auto impulses = fixture.stages.bodies.particleImpulses.download();
    for (const SoftBody& soft : fixture.world.softBodies) {
        SCOPED_TRACE("soft body of " + std::to_string(soft.particleCount));
        Vector3d sum = Vector3d::Zero(), torque = Vector3d::Zero();
        double size = 0.0;
        const Vector3d origin = place(soft.particleStart);
        for (uint32_t i = soft.particleStart; i < soft.particleStart + soft.particleCount; ++i) {
            const Vector3d p = vec3(impulses[places[i].y]).cast<double>();
            sum += p;
            torque += (place(i) - origin).cross(p);
            size += p.norm();
        }
        // Single precision; rotations are found to some 1e-6 of the pull, on arms of up to 0.7 m.
        EXPECT_LE(sum.norm(), 3e-6 * size);
        EXPECT_LE(torque.norm(), 1e-5 * size);
        EXPECT_EQ(size > 0.0, soft.clusterCount > 0);
    }
}

TEST_F(ClusterKernels, AnUnstrainedBodyIsNotPulled)
{
    const KernelFixture still(softWorld());
    Stages& b = fixture.stages;
    fill(b.bodies.moverCentres, still.stages.bodies.moverCentres.download());
    fill(b.bodies.moverMoves, std::vector<gpu::vec4>(moves.size()));
    fill(b.soft->clusterRests, still.stages.soft->clusterRests.download());
    match();
    pull();
    for (const gpu::vec4& p : b.soft->softImpulses.download()) {
        // Of places of 2 m, rounded to 1e-7 m, times a particle's 1.7 kg and less than the divisor.
        EXPECT_LT(vec3(p).norm(), 1e-6);
    }
}

}  // namespace

}  // namespace knuckle::test
