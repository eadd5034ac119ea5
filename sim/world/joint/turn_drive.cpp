#include "sim/world/joint/turn_drive.h"

#include <algorithm>

#include "sim/base/angles.h"

namespace knuckle {

TurnDrive speedMotor(float speed, float torque)
{
    constexpr float SLIP = 0.01f, LEAST_SLIP = 1e-3f;  // under the greatest load: of the speed, and [rad/s]
    TurnDrive drive;
    drive.damping = torque / std::max(SLIP * std::abs(speed), LEAST_SLIP);
    drive.speed = speed;
    drive.greatestTorque = torque;
    return drive;
}

TurnDrive angleMotor(float angle, float torque, float speed)
{
    constexpr float ARRIVAL = 0.2f;  // time in which what is left of its way becomes a third [s]
    TurnDrive drive;
    drive.stiffness = torque / radiansOf(1.0f);
    drive.damping = ARRIVAL * drive.stiffness;
    drive.angle = angle;
    drive.greatestTorque = torque;
    drive.greatestSpeed = speed;
    return drive;
}

}  // namespace knuckle
