#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tools/humanoid/humanoid_pose.h"

// The dance: sixteen beats of half a second. Steps to both sides, a full turn in six steps, a leap, and back. The feet
// are placed first, so that none can pass the floor, and the hips follow over them. In the air the hips move in free
// fall.
namespace knuckle {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double BEATS = 16.0;
constexpr double BEAT = 0.5;  // [s]
constexpr int KEYS_PER_BEAT = 15;
constexpr double CROUCH = 0.05;       // the hips are this much lower than at rest [m]
constexpr double STEP_HEIGHT = 0.09;  // [m]
constexpr double GRAVITY = 9.81;      // [m/s2]

// The leap, in beats: down, off the ground, on it again, up.
constexpr double DOWN = 9.2, OFF = 10.0, ON = 11.2, UP = 13.0;
constexpr double DEPTH = 0.2;  // of the hips before and after [m]

// A step of a foot from one place to the next.
struct Step {
    double from, to;  // [beats]
    double x, z;      // of the figure standing there [m]
    double yaw;       // [degrees]
};
const std::vector<Step> LEFT_STEPS = {{0.0, 0.9, 0.12, 0, 0},  {2.0, 2.9, 0.0, 0, 0},  {4.0, 4.7, 0, 0, 120},
                                      {5.4, 6.1, 0, 0, 240},   {6.8, 7.5, 0, 0, 360},  {OFF, ON, 0, 0.3, 360},
                                      {13.0, 13.8, 0, 0, 360}, {14.6, 15.4, 0, 0, 360}};
const std::vector<Step> RIGHT_STEPS = {{1.0, 1.9, 0.12, 0, 0}, {3.0, 3.9, 0.0, 0, 0}, {4.7, 5.4, 0, 0, 120},
                                       {6.1, 6.8, 0, 0, 240},  {7.5, 8.2, 0, 0, 360}, {OFF, ON, 0, 0.3, 360},
                                       {13.8, 14.6, 0, 0, 360}};

// A foot at a moment, except for its leg in the air.
struct Footing {
    Vector3d place{0, 0, 0};  // of the figure above it [m]
    double yaw = 0.0;         // [degrees]
    double lift = 0.0;        // 0 ... 1
};

Footing footingAt(const std::vector<Step>& steps, double beat)
{
    Footing now;
    for (const Step& step : steps) {
        const double way = smooth((beat - step.from) / (step.to - step.from));
        now.place += way * (Vector3d(step.x, 0, step.z) - now.place);
        now.yaw += way * (step.yaw - now.yaw);
        now.lift = std::max(now.lift, 4.0 * way * (1.0 - way));
    }
    return now;
}

bool flies(double beat)
{
    return beat > OFF && beat < ON;
}

// Height of the hips over that at rest [m].
double hipsHeight(double beat)
{
    const double flight = (ON - OFF) * BEAT, speed = 0.5 * GRAVITY * flight;
    const double bob = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * beat);
    const double calm = -CROUCH - 0.025 * bob * (1.0 - smooth(beat - 8.0) + smooth(beat - UP));
    // Cubic from one height and speed to another.
    const auto between = [&](double from, double to, double h0, double v0, double h1, double v1) {
        const double d = (to - from) * BEAT, t = (beat - from) / (to - from);
        return h0 * (1 + 2 * t) * (1 - t) * (1 - t) + d * v0 * t * (1 - t) * (1 - t) + h1 * t * t * (3 - 2 * t) +
               d * v1 * t * t * (t - 1);
    };
    if (beat < DOWN) return calm + (-DEPTH - calm) * smooth((beat - 8.2) / (DOWN - 8.2));
    if (beat < OFF) return between(DOWN, OFF, -DEPTH, 0, 0, speed);
    if (beat < ON) return speed * (beat - OFF) * BEAT - 0.5 * GRAVITY * std::pow((beat - OFF) * BEAT, 2);
    if (beat < 12.0) return between(ON, 12.0, 0, -speed, -DEPTH, 0);
    return -DEPTH + (calm + DEPTH) * smooth((beat - 12.0) / (UP - 12.0));
}

// Place of the hips over the feet, and their direction, smoothed.
Footing hipsAt(double beat)
{
    Footing mean;
    constexpr int HALF = 4, SAMPLES = 2 * HALF + 1;
    for (int i = -HALF; i <= HALF; ++i) {
        const double moment = beat + 0.9 * i / SAMPLES;
        const double wrapped = moment < 0 ? moment + BEATS : std::fmod(moment, BEATS);
        const Footing left = footingAt(LEFT_STEPS, wrapped), right = footingAt(RIGHT_STEPS, wrapped);
        // Moves over the standing foot.
        const Vector3d across = turn(0.5 * (left.yaw + right.yaw), Vector3d::UnitY()) * Vector3d::UnitX();
        const double lean = flies(wrapped) ? 0.0 : 0.075 * (right.lift - left.lift);
        mean.place += (0.5 * (left.place + right.place) + lean * across) / SAMPLES;
        // A full turn ends where it began.
        mean.yaw += (0.5 * (left.yaw + right.yaw) + (moment < 0 ? -360.0 : moment >= BEATS ? 360.0 : 0.0)) / SAMPLES;
    }
    return mean;
}

// An arm in the chest's directions: how high it points, how far forward from sideways, how far its elbow bends.
struct ArmKey {
    double beat, high, forward, elbow;  // [degrees]
};
const std::vector<ArmKey> LEFT_ARM = {{0, -40, 20, 30},    {1, 20, 30, 60},    {2, -50, 40, 70},   {3, 35, 10, 40},
                                      {4, 10, 60, 50},     {5.5, 5, 0, 10},    {7.5, -20, 40, 80}, {8.5, -55, 10, 30},
                                      {9.3, -60, -40, 15}, {10.2, 65, 45, 20}, {10.8, 40, 0, 10},  {11.4, 0, 10, 30},
                                      {12, -45, 30, 60},   {13, 55, 20, 45},   {14, -45, 30, 60},  {15, 60, 10, 30},
                                      {16, -40, 20, 30}};
const std::vector<ArmKey> RIGHT_ARM = {{0, -40, 20, 30},    {1, -50, 40, 70},   {2, 20, 30, 60},    {3, -50, 50, 80},
                                       {4, 10, -10, 20},    {5.5, 5, 0, 10},    {7.5, -20, 40, 80}, {8.5, -55, 10, 30},
                                       {9.3, -60, -40, 15}, {10.2, 65, 45, 20}, {10.8, 40, 0, 10},  {11.4, 0, 10, 30},
                                       {12, -45, 30, 60},   {13, -45, 30, 60},  {14, 55, 20, 45},   {15, 60, 10, 30},
                                       {16, -40, 20, 30}};

Arm armAt(double side, double beat)
{
    const std::vector<ArmKey>& keys = side > 0 ? LEFT_ARM : RIGHT_ARM;
    size_t k = 0;
    while (k + 2 < keys.size() && keys[k + 1].beat <= beat) ++k;
    const ArmKey &a = keys[k], &b = keys[k + 1];
    const double way = smooth((beat - a.beat) / (b.beat - a.beat));
    const double wave = std::sin(std::numbers::pi * beat + side);
    return {a.high + way * (b.high - a.high), a.forward + way * (b.forward - a.forward),
            a.elbow + way * (b.elbow - a.elbow), 15.0 * wave};
}

Ankle ankleAt(const Leg& leg, const Heads& rest, double beat, const Heads& heads, const Rotations& rotations)
{
    const Footing footing = footingAt(leg.side > 0 ? LEFT_STEPS : RIGHT_STEPS, beat);
    const Matrix3d yaw = turn(footing.yaw, Vector3d::UnitY());
    const Vector3d ground = footing.place + yaw * rest[leg.foot];
    if (!flies(beat)) return {ground + Vector3d(0, STEP_HEIGHT * footing.lift, 0), yaw, yaw * Vector3d::UnitZ()};
    // In the air one leg goes forward, one back, toes down.
    const double open = std::pow(std::sin(std::numbers::pi * (beat - OFF) / (ON - OFF)), 2);
    const Vector3d hanging = heads[HIPS] + rotations[HIPS] * (rest[leg.foot] - rest[HIPS]) + Vector3d(0, CROUCH, 0);
    const Vector3d spread = rotations[HIPS] * Vector3d(0, leg.side > 0 ? 0.22 : 0.12, leg.side * 0.42);
    return {hanging + open * spread, rotations[HIPS] * turn(35.0 * open, Vector3d::UnitX()),
            rotations[HIPS] * Vector3d(0, open, 1)};
}

void poseBody(double beat, const Heads& rest, Heads& heads, Rotations& rotations)
{
    const double pi = std::numbers::pi, sway = std::sin(0.5 * pi * beat), bob = 0.5 - 0.5 * std::cos(2.0 * pi * beat);
    const double fold = std::max(-hipsHeight(beat) - CROUCH, 0.0) / DEPTH;  // 1 in a crouch
    const double open = flies(beat) ? std::sin(pi * (beat - OFF) / (ON - OFF)) : 0.0;
    const Footing hips = hipsAt(beat);
    const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
    heads[HIPS] = rest[HIPS] + hips.place + Vector3d(0, hipsHeight(beat), 0);
    rotations[HIPS] = turn(hips.yaw, y) * turn(4.0 * sway, z) * turn(4.0 + 14.0 * fold, x);
    attach(SPINE, HIPS, turn(-4.0 * sway, z) * turn(8.0 * fold - 6.0 * open, x), rest, heads, rotations);
    attach(CHEST, SPINE,
           turn(-5.0 * sway, z) * turn(10.0 * std::sin(0.5 * pi * beat + 0.6), y) *
               turn(4.0 * bob + 6.0 * fold - 8.0 * open, x),
           rest, heads, rotations);
    attach(NECK, CHEST, turn(3.0 * bob - 4.0 * fold, x), rest, heads, rotations);
    // The eyes stay ahead for as long as they can while the body turns.
    const double ahead = 35.0 * std::sin(pi * std::clamp((beat - 3.5) / 5.0, 0.0, 1.0) * 2.0);
    attach(HEAD, NECK,
           turn(4.0 * sway, z) * turn(-ahead + 10.0 * std::sin(0.25 * pi * beat), y) *
               turn(6.0 * bob - 10.0 * fold - 8.0 * open, x),
           rest, heads, rotations);
}

void danceAt(double beat, const Heads& rest, Heads& heads, Rotations& rotations)
{
    poseBody(beat, rest, heads, rotations);
    poseArm(CLAVICLE_L, armAt(1.0, beat), rest, heads, rotations);
    poseArm(CLAVICLE_R, armAt(-1.0, beat), rest, heads, rotations);
    for (const Leg& leg : {LEFT_LEG, RIGHT_LEG})
        poseLeg(leg, ankleAt(leg, rest, beat, heads, rotations), rest, heads, rotations);
}

}  // namespace

Clip humanoidDance(const std::vector<Bone>& bones)
{
    const int keys = static_cast<int>(BEATS) * KEYS_PER_BEAT;
    return makeClip("dance", BEATS * BEAT, bones, [&](int key, const Heads& rest, Heads& heads, Rotations& rotations) {
        // The last key equals the first, to the bit.
        danceAt(static_cast<double>(key % keys) / KEYS_PER_BEAT, rest, heads, rotations);
    });
}

}  // namespace knuckle
