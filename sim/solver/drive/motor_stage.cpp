#include "sim/solver/drive/motor_stage.h"

#include <algorithm>
#include <limits>

#include "sim/solver/pack.h"

namespace knuckle {

namespace {

constexpr const char* KIND = "motor";

/// The driven joints of the trees; a joint that closes a loop is not driven (validateJoints()).
std::vector<uint32_t> drivenJoints(const World& world, const JointTrees& trees)
{
    std::vector<uint32_t> driven;
    for (uint32_t k = 0; k < trees.joints.size(); ++k)
        if (const uint32_t j = trees.joints[k].joint; j != NO_INDEX && world.joints[j].drive.acts())
            driven.push_back(k);
    return driven;
}

float bounded(float greatest)
{
    return std::min(greatest, std::numeric_limits<float>::max());
}

void putDrive(gpu::Motor& motor, const TurnDrive& drive)
{
    motor.stiffness = drive.stiffness;
    motor.damping = drive.damping;
    motor.angle = drive.angle;
    motor.speed = drive.speed;
    motor.greatestTorque = bounded(drive.greatestTorque);
    // Beyond it the spring asks for the speed of which the damper takes as much back.
    motor.reach = bounded(drive.stiffness > 0.0f ? drive.greatestSpeed * drive.damping / drive.stiffness
                                                 : std::numeric_limits<float>::max());
    motor.keepsAwake = drive.isMotor() ? 1 : 0;
}

gpu::Motor packMotor(const World& world, const JointTrees::Joint& joint)
{
    const Joint& record = world.joints[joint.joint];
    const Quaternionf turn = joint.body == record.child ? record.turn : record.turn.conjugate();
    gpu::Motor motor{};
    motor.frame = pack(joint.side.frame);
    motor.parentFrame = pack((turn * joint.side.frame).normalized());
    putDrive(motor, record.drive);
    motor.isHinge = record.type == JointType::Hinge ? 1 : 0;
    motor.body = joint.body;
    motor.parent = joint.parent;
    return motor;
}

}  // namespace

bool MotorStage::isNeeded(const World& world)
{
    return std::ranges::any_of(world.joints, [](const Joint& joint) { return joint.drive.acts(); });
}

void MotorStage::reserveRows(RowPlan& rows, const World& world, const Layout& layout)
{
    for (const uint32_t k : drivenJoints(world, layout.jointTrees)) {
        const JointTrees::Joint& joint = layout.jointTrees.joints[k];
        rows.reserveAngular(KIND, joint.body);
        if (!neverResponds(world.bodies[joint.parent])) rows.reserveAngular(KIND, joint.parent);
    }
}

void MotorStage::upload(const StageSetup& setup)
{
    const std::vector<uint32_t> rows = setup.rows.rowsOf(KIND);
    std::vector<gpu::Motor> packed;
    std::vector<gpu::vec4> states;
    size_t next = 0;
    for (const uint32_t k : drivenJoints(setup.world, setup.layout.jointTrees)) {
        gpu::Motor motor = packMotor(setup.world, setup.layout.jointTrees.joints[k]);
        motor.joint = k;
        motor.row = rows[next++];
        motor.parentRow = neverResponds(setup.world.bodies[motor.parent]) ? NO_INDEX : rows[next++];
        packed.push_back(motor);
        states.push_back(motor.isHinge == 1 ? gpu::vec4{0, 0, 0, 0} : gpu::vec4{0, 0, 0, 1});
        states.push_back({0, 0, 0, 0});
    }
    setup.parameters.motorCount = static_cast<uint32_t>(packed.size());
    motors = {"motors", std::span<const gpu::Motor>(packed)};
    motorStates = {"motorStates", std::span<const gpu::vec4>(states)};
}

bool MotorStage::set(const Layout& layout, uint32_t joint, const TurnDrive& drive)
{
    std::vector<gpu::Motor> all = motors.download();
    const auto found = std::ranges::find_if(
        all, [&](const gpu::Motor& motor) { return layout.jointTrees.joints[motor.joint].joint == joint; });
    if (found == all.end()) return false;
    putDrive(*found, drive);
    motors.upload(all);
    return true;
}

void MotorStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, motors);
    table.add(Lifetime::State, motorStates);
}

void MotorStage::begin(Recorder& recorder) const
{
    recorder.perElement(begin_, parameters_.motorCount);
}

void MotorStage::turn(Recorder& recorder) const
{
    recorder.perElement(turn_, parameters_.motorCount);
}

}  // namespace knuckle
