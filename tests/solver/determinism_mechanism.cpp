#include "tests/solver/determinism_worlds.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {

World mechanismWorld()
{
    WorldBuilder builder = sleepyBuilder();
    std::vector<HingeBodies> hinges;
    const TurnDrive spring{.stiffness = 40, .damping = 1};
    const std::vector<TurnDrive> drives = {speedMotor(6, 30), angleMotor(2, 20, 1.5f), spring, spring, spring};
    for (size_t k = 0; k < drives.size(); ++k) {
        const Vector3f place(0, 0.5f, 0.8f * static_cast<float>(k));
        std::vector<uint32_t> bodies;
        for (const float x : {0.0f, 0.35f}) {
            builder.beginObject("bar");
            bodies.push_back(builder.addBody("bar", boxLattice({3, 2, 3}, DIAMETER), 0));
            builder.endObject({place + Vector3f(x, 0, 0)});
        }
        JointSpec spec;
        spec.type = k == 3 ? JointType::Ball : k == 4 ? JointType::Universal : JointType::Hinge;
        spec.anchor = place + Vector3f(-0.2f, 0, 0);
        spec.drive = drives[k];
        if (k == 1) spec.limits.bend = {-0.5f, 1};
        if (k == 2) spec.strength.force = 150;
        spec.geared = spec.type == JointType::Hinge;
        hinges.push_back({builder.joinPlaced(NO_INDEX, bodies[0], spec), bodies[0]});
        spec.anchor = place + Vector3f(0.175f, 0, 0);
        spec.drive = drives[(k + 2) % 3];
        spec.type = JointType::Hinge;
        spec.geared = false;
        builder.joinPlaced(bodies[0], bodies[1], spec);
    }
    builder.addGear("gear", hinges[0], hinges[2], 1.5f);
    return builder.build();
}

}  // namespace knuckle::test
