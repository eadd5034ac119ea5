#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "tools/dog/dog_parts.h"
#include "tools/shapes/pose.h"

// Toes are placed first, and do not move on the ground; the legs above them follow.
namespace knuckle {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

struct Gait {
    const char* name;
    double duration;               // of a stride [s]
    double stride, swing, height;  // from one stand to the next [m], share of the time in the air, of a lifted paw [m]
    double crouch, bob;            // how much lower the hips are than at rest, and how far they go up and down [m]
    double bobs;                   // per stride
    std::array<double, 4> phases;  // of back left, front left, back right, front right: when they are set down
};
constexpr Gait WALK{"walk", 0.6, 0.48, 0.36, 0.07, 0.020, 0.006, 2.0, {0.0, 0.75, 0.5, 0.25}};
constexpr Gait TROT{"trot", 0.4, 0.60, 0.50, 0.09, 0.028, 0.012, 2.0, {0.0, 0.5, 0.5, 0.0}};

const Vector3d X = Vector3d::UnitX(), Y = Vector3d::UnitY(), Z = Vector3d::UnitZ();
constexpr double FRONT_TOE = 0.236, BACK_TOE = -0.236;  // place of the paws' tips, on which they roll [m]

class Dog {
public:
    Dog(const Skeleton& skeleton, const Gait& gait, double phase, const Heads& rest, Heads& heads, Rotations& rotations)
        : skeleton_(skeleton), gait_(gait), phase_(phase), rest_(rest), heads_(heads), rotations_(rotations)
    {
    }

    void pose()
    {
        poseTrunk();
        poseBack(".L", gait_.phases[0]);
        poseFront(".L", gait_.phases[1]);
        poseBack(".R", gait_.phases[2]);
        poseFront(".R", gait_.phases[3]);
    }

private:
    uint32_t bone(const std::string& name) const { return boneIndex(skeleton_, name); }

    void turnBone(const std::string& name, const Matrix3d& local)
    {
        const uint32_t b = bone(name);
        attach(b, static_cast<uint32_t>(skeleton_[b].parent), local, rest_, heads_, rotations_);
    }

    void poseTrunk()
    {
        const double sway = wave(phase_ + 0.1), beat = wave(gait_.bobs * phase_ + 0.15);
        const uint32_t hips = bone("hips");
        heads_[hips] = rest_[hips] + Vector3d(0.008 * sway, gait_.bob * beat - gait_.crouch, gait_.stride * phase_);
        rotations_[hips] = turn(4.0 * sway, Y) * turn(2.5 * sway, Z) * turn(1.2 * beat, X);
        turnBone("spine.001", turn(-4.0 * sway, Y) * turn(-2.0 * sway, Z));
        turnBone("chest", turn(-4.0 * sway, Y) * turn(-2.5 * sway, Z) * turn(-1.5 * beat, X));
        turnBone("neck", turn(2.0 * sway, Y) * turn(2.5 * beat + 3.0, X));
        turnBone("head", turn(2.0 * sway, Y) * turn(-2.0 * beat - 2.0, X));
        for (const char* side : {".L", ".R"}) turnBone(std::string("ear") + side, turn(-5.0 * beat, X));
        for (int i = 1; i <= 3; ++i)
            turnBone("tail.00" + std::to_string(i),
                     turn(11.0 * wave(phase_ + 0.1 - 0.14 * i), Y) * turn(3.0 * beat, X));
    }

    Footfall footfall(double set) const
    {
        Footfall fall = footfallAt(phase_ - set + 1.0, gait_.stride, gait_.swing);
        fall.along += (set - 1.0) * gait_.stride;
        return fall;
    }

    // Poses two bones from the upper one's place to the required start of the foot.
    void poseLeg(const std::array<uint32_t, 3>& bones, const Vector3d& end, const Vector3d& pole)
    {
        const auto [upper, lower, foot] = bones;
        const Vector3d thigh = rest_[lower] - rest_[upper], shin = rest_[foot] - rest_[lower];
        const BentLimb bent = bend(heads_[upper], end - heads_[upper], thigh.norm(), shin.norm(), pole);
        heads_[lower] = bent.middle;
        heads_[foot] = bent.end;
        rotations_[upper] = aim(thigh, pole, bent.middle - heads_[upper], bent.normal);
        rotations_[lower] = aim(shin, pole, bent.end - bent.middle, bent.normal);
    }

    void poseFront(const std::string& side, double set)
    {
        const Footfall fall = footfall(set);
        const uint32_t upper = bone("front_upper_leg" + side), foot = bone("front_foot" + side);
        // The shoulder blade turns with the leg: ahead as it is set down, back as it leaves the ground.
        const double ahead = std::cos(std::numbers::pi * (fall.way > 0.0 ? 1.0 + fall.way : fall.stand));
        turnBone("front_shoulder" + side, turn(-13.0 * ahead, X));
        turnBone("front_upper_leg" + side, Matrix3d::Identity());
        const double roll = 40.0 * smooth((fall.stand - 0.7) / 0.3) * (1.0 - smooth(fall.way / 0.8));
        rotations_[foot] = turn(roll + 45.0 * fall.lift * (1.0 - fall.way), X);
        const Vector3d toe(rest_[foot].x(), 0.0, FRONT_TOE);
        const Vector3d place = toe + Vector3d(0, gait_.height * fall.lift, fall.along);
        poseLeg({upper, bone("front_lower_leg" + side), foot}, place + rotations_[foot] * (rest_[foot] - toe), -Z);
    }

    void poseBack(const std::string& side, double set)
    {
        const Footfall fall = footfall(set);
        const uint32_t upper = bone("back_upper_leg" + side), foot = bone("back_foot" + side);
        const uint32_t toes = bone("back_toe" + side);
        turnBone("back_upper_leg" + side, Matrix3d::Identity());
        const double roll = 30.0 * smooth((fall.stand - 0.75) / 0.25) * (1.0 - smooth(fall.way / 0.8));
        rotations_[toes] = turn(roll + 25.0 * fall.lift * (1.0 - fall.way), X);
        rotations_[foot] = turn(-8.0 + 36.0 * smooth(fall.stand) * (1.0 - smooth(fall.way)) + 14.0 * fall.lift, X);
        const Vector3d tip(rest_[toes].x(), 0.0, BACK_TOE);
        const Vector3d place = tip + Vector3d(0, gait_.height * fall.lift, fall.along);
        const Vector3d joint = place + rotations_[toes] * (rest_[toes] - tip);
        poseLeg({upper, bone("back_lower_leg" + side), foot}, joint - rotations_[foot] * (rest_[toes] - rest_[foot]),
                Z);
        heads_[toes] = heads_[foot] + rotations_[foot] * (rest_[toes] - rest_[foot]);
    }

    const Skeleton& skeleton_;
    const Gait& gait_;
    double phase_;
    const Heads& rest_;
    Heads& heads_;
    Rotations& rotations_;
};

Clip clipOf(const Skeleton& skeleton, const Gait& gait)
{
    const double keys = gait.duration * KEYS_PER_SECOND;
    return makeClip(gait.name, gait.duration, bonesOf(skeleton),
                    [&](int key, const Heads& rest, Heads& heads, Rotations& rotations) {
                        Dog(skeleton, gait, key / keys, rest, heads, rotations).pose();
                    });
}

}  // namespace

Clip dogWalk(const Skeleton& skeleton)
{
    return clipOf(skeleton, WALK);
}

Clip dogTrot(const Skeleton& skeleton)
{
    return clipOf(skeleton, TROT);
}

}  // namespace knuckle
