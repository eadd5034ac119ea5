#include "app/bench/table2_world.h"

#include <fmt/format.h>

#include "sim/world/space/frames.h"

namespace knuckle {

namespace {

constexpr float DIAMETER = 0.1f;
constexpr uint32_t COLUMNS = 5, ROWS = 10;
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

}  // namespace

void addBenchBox(WorldBuilder& builder)
{
    Collider floor;
    builder.addCollider(floor);
    for (const Vector3f& inward : {Vector3f(1, 0, 0), Vector3f(-1, 0, 0), Vector3f(0, 0, 1), Vector3f(0, 0, -1)}) {
        Collider wall;
        wall.position = -HALF_WIDTH * inward;
        wall.orientation = turnBetween(Vector3f::UnitY(), inward);
        wall.visible = false;
        builder.addCollider(wall);
    }
}

World table2World(uint32_t objectCount, const Settings& settings)
{
    WorldBuilder builder(DIAMETER / 2, settings);
    Material material;
    material.name = "block";
    const uint32_t block = builder.addMaterial(material);
    addBenchBox(builder);
    for (uint32_t i = 0; i < objectCount; ++i) {
        const uint32_t layer = i / (COLUMNS * ROWS), column = i % COLUMNS, row = i / COLUMNS % ROWS;
        Pose pose;
        // A small shift, different from layer to layer, so that columns topple instead of balancing.
        const float shiftX = 0.009f * (static_cast<float>((7 * i + 2 * layer) % 5) - 2.0f);
        const float shiftZ = 0.009f * (static_cast<float>((3 * i + layer) % 5) - 2.0f);
        pose.translation = {(static_cast<float>(column) - 2.0f) * 0.78f + shiftX,
                            LAYER_HEIGHT * static_cast<float>(layer + 1),
                            (static_cast<float>(row) - 4.5f) * 0.38f + shiftZ};
        addPair(builder, i, block, pose);
    }
    return builder.build();
}

}  // namespace knuckle
