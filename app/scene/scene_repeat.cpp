#include "app/scene/scene_repeat.h"

#include <cmath>
#include <random>

#include "app/json/fields.h"
#include "app/scene/scene_places.h"
#include "sim/base/angles.h"
#include "sim/base/random.h"

namespace knuckle {

namespace {

/// Uniform distribution over all rotations (Shoemake 1992, "Uniform random rotations").
Quaternionf randomRotation(std::mt19937& random)
{
    const float share = uniformFraction(random);
    const float first = WHOLE_TURN * uniformFraction(random);
    const float second = WHOLE_TURN * uniformFraction(random);
    const float a = std::sqrt(1.0f - share), b = std::sqrt(share);
    return Quaternionf(b * std::cos(second), a * std::sin(first), a * std::cos(first), b * std::sin(second));
}

}  // namespace

uint64_t copyCount(const Json& object)
{
    uint64_t count = 1;
    for (const Json& side : object["repeat"]["counts"]) count *= side.get<uint64_t>();
    return count;
}

float delayOf(const Json& object, size_t copy)
{
    const Json& repeat = object["repeat"];
    const size_t nx = repeat["counts"][0], nz = repeat["counts"][2];
    const Vector3f cell = Eigen::Vector3<size_t>(copy % nx, copy / (nx * nz), copy / nx % nz).cast<float>();
    Vector3f delay;
    readValue(repeat["delay"], delay);
    return cell.dot(delay);
}

std::vector<ClipPlay> delayed(const World& world, std::vector<ClipPlay> plays, float delay)
{
    ClipPlay& first = plays.front();
    first.start -= delay * first.speed;
    const float length = world.clips[first.clip].duration();
    if (first.loop && first.start < 0.0f && length > 0.0f) first.start -= length * std::floor(first.start / length);
    for (size_t i = 1; i < plays.size(); ++i) plays[i].at += delay;
    return plays;
}

std::vector<Pose> repeatedPoses(const Json& object)
{
    const Json& repeat = object["repeat"];
    const int nx = repeat["counts"][0], ny = repeat["counts"][1], nz = repeat["counts"][2];
    const float jitter = repeat["jitter"];
    const bool turned = repeat["randomRotation"];
    std::mt19937 random(repeat["seed"].get<uint32_t>());
    Vector3f position, spacing;
    readValue(object["position"], position);
    readValue(repeat["spacing"], spacing);
    const Quaternionf rotation = readRotation(object);
    const Vector3f first(0.5f * static_cast<float>(1 - nx), 0.0f, 0.5f * static_cast<float>(1 - nz));
    std::vector<Pose> poses;
    poses.reserve(copyCount(object));
    for (int y = 0; y < ny; ++y) {
        for (int z = 0; z < nz; ++z) {
            for (int x = 0; x < nx; ++x) {
                const Vector3f cell(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
                Pose pose{position + (first + cell).cwiseProduct(spacing), rotation};
                // One statement per axis: C++ does not define the order in which arguments of one call are evaluated.
                for (float& side : pose.translation) side += jitter * (2.0f * uniformFraction(random) - 1.0f);
                if (turned) pose.rotation = randomRotation(random) * rotation;
                poses.push_back(pose);
            }
        }
    }
    return poses;
}

}  // namespace knuckle
