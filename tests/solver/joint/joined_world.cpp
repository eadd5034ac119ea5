#include "tests/solver/joint/joined_world.h"

#include <algorithm>
#include <cmath>

#include "tests/solver/solver_test.h"

namespace knuckle::test {

World joinedWorld(uint32_t bodies, const std::vector<Joining>& joints, const std::vector<uint32_t>& fixed,
                  float density, const Settings& settings)
{
    WorldBuilder builder(DIAMETER / 2, settings);
    Material usual, other;
    other.density = density;
    builder.addMaterial(usual);
    builder.addMaterial(other);
    builder.beginObject("joined");
    std::vector<Vector3f> centres;
    for (uint32_t b = 0; b < bodies; ++b) {
        const auto k = static_cast<float>(b);
        centres.emplace_back(0.4f * k, 0.3f * std::sin(k), 0.2f * std::cos(2 * k));
        std::vector<Vector3f> places = boxLattice({3, 2, 3}, DIAMETER);
        for (Vector3f& p : places) p += centres.back();
        const bool stays = std::ranges::find(fixed, b) != fixed.end();
        builder.addBody("body" + std::to_string(b), places, b % 2, stays ? Motion::Fixed : Motion::Dynamic);
    }
    for (const Joining& joining : joints) {
        JointSpec spec;
        spec.type = joining.type;
        spec.anchor = 0.5f * (centres[joining.a] + centres[joining.b]);
        spec.along = (centres[joining.b] - centres[joining.a]).normalized();
        builder.addJoint(joining.a, joining.b, spec);
    }
    builder.endObject();
    return builder.build();
}

World branchedWorld(const Settings& settings)
{
    return joinedWorld(10,
                       {{2, 1, JointType::Ball},
                        {2, 3, JointType::Hinge},
                        {3, 4, JointType::Stiff},
                        {3, 5, JointType::Ball},
                        {5, 0, JointType::Universal},
                        {6, 7, JointType::Hinge},
                        {7, 8, JointType::Ball}},
                       {6}, 3000.0f, settings);
}

World ringWorld()
{
    return joinedWorld(4, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
}

}  // namespace knuckle::test
