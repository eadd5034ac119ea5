#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/view/camera_keys.h"
#include "render/view/camera_shake.h"
#include "sim/base/angles.h"

namespace knuckle::test {
namespace {

constexpr float ROUNDING = 1e-5f;

/// Keys of a camera that only rises and falls, at the times 0, 1, 3, 4, 6.
std::vector<CameraKey> rising(Easing easing)
{
    std::vector<CameraKey> keys;
    const double times[] = {0, 1, 3, 4, 6};
    const float heights[] = {1, 2, 2, 5, 0.5f};
    for (int k = 0; k < 5; ++k) {
        CameraKey key{.time = times[k], .position = {0, heights[k], 6}, .easing = easing};
        key.fieldOfView = 40 + 3 * heights[k];
        key.roll = -heights[k];
        keys.push_back(key);
    }
    return keys;
}

float heightAt(const std::vector<CameraKey>& keys, double time)
{
    return poseAt(keys, time).position.y();
}

TEST(CameraKeys, ArePassedAndEndTheWay)
{
    for (int easing = 0; easing < 6; ++easing) {
        const std::vector<CameraKey> keys = rising(static_cast<Easing>(easing));
        for (const CameraKey& key : keys) {
            const CameraPose pose = poseAt(keys, key.time);
            EXPECT_NEAR((pose.position - key.position).norm(), 0, ROUNDING) << easing << " at " << key.time;
            EXPECT_NEAR(pose.fieldOfView, key.fieldOfView, ROUNDING) << easing;
            EXPECT_NEAR(pose.roll, key.roll, ROUNDING) << easing;
        }
        EXPECT_EQ(heightAt(keys, -1), 1.0f);
        EXPECT_EQ(heightAt(keys, 100), 0.5f);
    }
}

TEST(CameraKeys, AreJoinedWithoutAJoltAndNeverLeftBehind)
{
    const std::vector<CameraKey> keys = rising(Easing::Smooth);
    constexpr double STEP = 1e-3;
    double speed = 0.0;
    for (double time = 0.0; time < 6.0; time += STEP) {
        const double next = (double{heightAt(keys, time + STEP)} - double{heightAt(keys, time)}) / STEP;
        // The curve's acceleration is below 20 m/s2; floats round places by 1e-7 m.
        EXPECT_NEAR(next, speed, 20 * STEP + 1e-3) << time;
        speed = next;
        const auto after = std::ranges::find_if(keys, [&](const CameraKey& key) { return key.time > time; });
        const float a = std::prev(after)->position.y(), b = after->position.y(), here = heightAt(keys, time);
        EXPECT_GE(here, std::min(a, b) - ROUNDING) << time;
        EXPECT_LE(here, std::max(a, b) + ROUNDING) << time;
    }
}

TEST(CameraKeys, OfOneSpeedAreAStraightLine)
{
    std::vector<CameraKey> keys;
    for (const double time : {0.0, 1.0, 3.0, 4.0})
        keys.push_back({.time = time, .position = {static_cast<float>(time), 1, 6}});
    for (const double time : {1.25, 2.0, 2.9}) EXPECT_NEAR(poseAt(keys, time).position.x(), time, ROUNDING);
}

TEST(CameraKeys, EaseAsTheirFormulasSay)
{
    const auto share = [](Easing easing, double t) {
        const std::vector<CameraKey> keys{{.time = 2, .position = {0, 0, 6}, .easing = easing},
                                          {.time = 4, .position = {0, 1, 6}}};
        return heightAt(keys, 2 + 2 * t);
    };
    for (const double t : {0.2, 0.5, 0.9}) {
        EXPECT_NEAR(share(Easing::Linear, t), t, ROUNDING);
        EXPECT_NEAR(share(Easing::EaseIn, t), t * t, ROUNDING);
        EXPECT_NEAR(share(Easing::EaseOut, t), 1 - (1 - t) * (1 - t), ROUNDING);
        EXPECT_NEAR(share(Easing::EaseInOut, t), t * t * (3 - 2 * t), ROUNDING);
        EXPECT_NEAR(share(Easing::Smooth, t), t * t * (3 - 2 * t), ROUNDING) << "two keys: rests at both";
        EXPECT_EQ(share(Easing::Hold, t), 0.0f);
    }
}

TEST(CameraShake, StaysWithinItsBoundAndAroundZero)
{
    const CameraShake shake{.amplitude = 2, .frequency = 1.5, .seed = 4};
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Vector3f most = Eigen::Vector3f::Zero();
    constexpr int SAMPLES = 12000;
    for (int i = 0; i < SAMPLES; ++i) {
        const Eigen::Vector3f angles = shakeAt(shake, i / 20.0);
        sum += angles.cast<double>();
        most = most.cwiseMax(angles.cwiseAbs());
        const Eigen::Vector3f soon = shakeAt(shake, i / 20.0 + 1e-3);
        // 2 degrees at 3.49 times 1.5 Hz at most: 2 pi 5.2 times 0.035, in a thousandth of a second.
        EXPECT_LT((soon - angles).cwiseAbs().maxCoeff(), 1.2e-3f) << i;
    }
    for (int axis = 0; axis < 3; ++axis) {
        const float bound = (axis == 2 ? 1 : 2) * DEGREE;
        EXPECT_LE(most[axis], bound) << axis;
        EXPECT_GT(most[axis], 0.5f * bound) << axis;
        // Ten minutes of the slowest wave, 0.5 Hz, are 300 rounds.
        EXPECT_NEAR(sum[axis] / SAMPLES, 0.0, 0.01 * bound) << axis;
    }
}

TEST(CameraShake, DependsOnTimeAndSeedAlone)
{
    CameraShake shake{.amplitude = 1, .frequency = 1, .seed = 1};
    const Eigen::Vector3f once = shakeAt(shake, 3.25);
    shakeAt(shake, 9.0);
    EXPECT_EQ(shakeAt(shake, 3.25), once);
    shake.seed = 2;
    EXPECT_GT((shakeAt(shake, 3.25) - once).norm(), 0.1f * DEGREE);
}

}  // namespace
}  // namespace knuckle::test
