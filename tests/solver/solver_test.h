#pragma once

#include <gtest/gtest.h>

#include <random>
#include <span>
#include <string>
#include <vector>

#include "sim/solver/stages.h"
#include "sim/world/builder/builder.h"
#include "tests/message_of.h"
#include "tests/temp_folder.h"

namespace knuckle::test {

using Eigen::Matrix3d;
using Eigen::Vector3d;

inline constexpr float DIAMETER = 0.1f;

/// Overrides the shaders of gpu(): tests put their own kernels here.
TempFolder& shaderFolder();
/// One context for the whole test program: making one costs more than most tests.
Gpu& gpu();

/// Numbers that are equal with every standard library, unlike those of its distributions.
class Random {
public:
    explicit Random(uint32_t seed) : engine_(seed) {}
    float between(float low, float high)
    {
        return low + (high - low) * (static_cast<float>(engine_() >> 8) * 0x1p-24f);
    }
    Vector3f inCube(float half) { return {between(-half, half), between(-half, half), between(-half, half)}; }
    gpu::vec4 vec4(float half)
    {
        const Vector3f v = inCube(half);
        return {v.x(), v.y(), v.z(), 0};
    }
    Vector3f direction();
    Quaternionf rotation();

private:
    std::mt19937 engine_;
};

/// A world of everything that kernels distinguish, in 1003 particles (no multiple of any group size): pairs of each
/// joint type, two bodies with a margin whose lattices overlap at rest, a pair of which one is fixed, a flat, a
/// straight and a long body, a fixed one, and loose particles for the rest.
World mixedWorld(const Settings& settings = {}, uint32_t particleCount = 1003);

/// The defaults except for the solver, so that a world has the paper's stages.
Settings byThePaper();

/// The solver's stages of a world, and its kernels one at a time.
class KernelFixture {
public:
    explicit KernelFixture(World worldIn) : world(std::move(worldIn)), stages(gpu(), world) {}

    Kernel load(const std::string& name, const Defines& defines = {});
    void dispatch(const Kernel& kernel, uint32_t groups) { kernel.dispatch(timer_, groups); }
    void run(const std::string& name, uint64_t threads, const Defines& defines = {});
    void forParticles(const std::string& name, const Defines& defines = {});
    void forBodies(const std::string& name, const Defines& defines = {});
    void forMovers(const std::string& name, const Defines& defines = {});
    /// Sets the places for which contacts are found, as search_position would [m], and no references to pairs yet.
    void setFound(const std::vector<gpu::vec4>& places);
    /// Sorts the particles into the grid by searchPositions, as the step does.
    void fillGrid(const Defines& defines);
    /// Finds the pairs of particles, as the step does; counters().fastListed of fastParticles look further.
    void findPairs(GridKind grid);
    /// Makes the lists of contacts found for particles and colliders (listCounts), as the step does.
    void fillLists();
    /// Makes the next search write the other half of the lists.
    void turnHalves();
    /// Uploads `stages.parameters` after a change.
    void setParameters() { stages.step.upload(std::span<const gpu::StepParameters>(&stages.parameters, 1)); }
    gpu::Counters counters() const { return stages.counters.download()[0]; }
    void setCounters(const gpu::Counters& c) { stages.counters.upload(std::span<const gpu::Counters>(&c, 1)); }

    World world;
    Stages stages;

private:
    KernelTimer timer_;
};

inline Vector3f vec3(const gpu::vec4& v)
{
    return {v.x, v.y, v.z};
}
inline gpu::vec4 packed(const Vector3f& v, float w = 0.0f)
{
    return {v.x(), v.y(), v.z(), w};
}
inline gpu::vec4 packed(const Quaternionf& q)
{
    return {q.x(), q.y(), q.z(), q.w()};
}
inline Quaternionf quaternion(const gpu::vec4& v)
{
    return {v.w, v.x, v.y, v.z};
}

/// The step's defines for a kernel that uses the grid.
Defines gridDefines(GridKind kind);
/// A plane through a place, solid behind it.
Collider planeAt(const Vector3f& place, const Vector3f& normal);
/// For the names of tests that run with each grid.
std::string gridName(const testing::TestParamInfo<GridKind>& kind);

/// Writes a whole buffer.
template <typename T>
void fill(Buffer<T>& buffer, const std::vector<T>& values)
{
    ASSERT_EQ(buffer.size(), values.size());
    buffer.upload(std::span<const T>(values));
}

/// `count` random vectors within +-half, w = 0.
std::vector<gpu::vec4> randomVectors(size_t count, float half, uint32_t seed);

}  // namespace knuckle::test
