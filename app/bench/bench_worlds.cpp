#include "app/bench/bench_worlds.h"

#include <fmt/format.h>

#include "sim/world/matter/grain.h"
#include "sim/world/space/frames.h"

namespace knuckle {

namespace {

constexpr float DIAMETER = 0.1f;
constexpr uint32_t COLUMNS = 5;
constexpr float HALF_WIDTH = 2.0f, LAYER_HEIGHT = 0.4f;

/// Two cubes with a layer of one diameter between them for the joint's particles.
void addPair(WorldBuilder& builder, uint32_t index, uint32_t material, const Pose& pose)
{
    static constexpr JointType TYPES[] = {JointType::Stiff, JointType::Hinge, JointType::Ball, JointType::Universal};
    std::vector<Vector3f> left = boxLattice({3, 3, 3}, DIAMETER), right = left;
    const Vector3f offset(2 * DIAMETER, 0, 0);
    for (Vector3f& p : left) p -= offset;
    for (Vector3f& p : right) p += offset;
    builder.beginObject(fmt::format("pair {}", index));
    const uint32_t a = builder.addBody("left", left, material), b = builder.addBody("right", right, material);
    JointSpec joint;
    joint.type = TYPES[index % 4];
    joint.name = "joint";
    joint.limitSide = 1;
    builder.addJoint(a, b, joint);
    builder.endObject(pose);
}

/// Floor and walls about the middle.
void addBox(WorldBuilder& builder, float halfX, float halfZ)
{
    Collider floor;
    builder.addCollider(floor);
    for (const Vector3f& inward : {Vector3f(1, 0, 0), Vector3f(-1, 0, 0), Vector3f(0, 0, 1), Vector3f(0, 0, -1)}) {
        Collider wall;
        wall.position = -(inward.x() != 0.0f ? halfX : halfZ) * inward;
        wall.orientation = turnBetween(Vector3f::UnitY(), inward);
        wall.visible = false;
        builder.addCollider(wall);
    }
}

/// Places of a column on the floor, in the left half of a box twice as wide, which is added.
std::vector<Vector3f> addColumn(WorldBuilder& builder, const Eigen::Vector3i& counts, float pitch)
{
    const Vector3f size = pitch * counts.cast<float>();
    addBox(builder, size.x(), 0.5f * size.z());
    std::vector<Vector3f> places = boxLattice(counts, pitch);
    for (Vector3f& place : places) place += Vector3f(-0.5f * size.x(), 0.5f * size.y(), 0.0f);
    return places;
}

}  // namespace

void addBenchBox(WorldBuilder& builder)
{
    addBox(builder, HALF_WIDTH, HALF_WIDTH);
}

World damWorld(const Eigen::Vector3i& counts, const Settings& settings)
{
    WorldBuilder builder(DIAMETER / 2, settings);
    Material water;
    water.name = "water";
    water.fluid = true;
    const uint32_t material = builder.addMaterial(water);
    builder.addFluid(addColumn(builder, counts, builder.fluidSpacing()), Vector3f::Zero(), material);
    return builder.build();
}

World sandWorld(const Eigen::Vector3i& counts, const Settings& settings)
{
    WorldBuilder builder(DIAMETER / 2, settings);
    Material sand;
    sand.name = "sand";
    const uint32_t material = builder.addMaterial(sand);
    const std::vector<Vector3f> places = addColumn(builder, counts, DIAMETER);
    for (uint32_t k = 0; k < places.size(); ++k) {
        Particle grain;
        grain.material = material;
        grain.mass = builder.particleMass(material);
        grain.scale = grainScale(k);
        grain.position = grain.restPosition = places[k];
        builder.addLooseParticle(grain);
    }
    return builder.build();
}

World table2World(uint32_t objectCount, const Settings& settings)
{
    return pairsWorld(objectCount, COLUMNS, settings);
}

World pairsWorld(uint32_t objectCount, uint32_t columns, const Settings& settings)
{
    WorldBuilder builder(DIAMETER / 2, settings);
    Material material;
    material.name = "block";
    const uint32_t block = builder.addMaterial(material);
    const uint32_t rows = 2 * columns;
    const float halfWidth = HALF_WIDTH / COLUMNS * static_cast<float>(columns);
    addBox(builder, halfWidth, halfWidth);
    for (uint32_t i = 0; i < objectCount; ++i) {
        const uint32_t layer = i / (columns * rows), column = i % columns, row = i / columns % rows;
        Pose pose;
        // A small shift, different from layer to layer, so that columns topple instead of balancing.
        const float shiftX = 0.009f * (static_cast<float>((7 * i + 2 * layer) % 5) - 2.0f);
        const float shiftZ = 0.009f * (static_cast<float>((3 * i + layer) % 5) - 2.0f);
        pose.translation = {fromMiddle(column, columns) * 0.78f + shiftX, LAYER_HEIGHT * static_cast<float>(layer + 1),
                            fromMiddle(row, rows) * 0.38f + shiftZ};
        addPair(builder, i, block, pose);
    }
    return builder.build();
}

}  // namespace knuckle
