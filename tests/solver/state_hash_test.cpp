#include <gtest/gtest.h>

#include <bit>
#include <set>

#include "sim/solver/solver.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {
namespace {

/// Grains that fall, all a little differently.
World grains(uint32_t count)
{
    WorldBuilder builder(DIAMETER / 2);
    builder.addMaterial({});
    for (uint32_t i = 0; i < count; ++i) {
        const auto f = static_cast<float>(i);
        Particle grain;
        grain.position = {0.3f * f, 1.0f + 0.01f * f, -0.2f * f};
        builder.addLooseParticle(grain);
    }
    return builder.build();
}

TEST(StateHash, OfTheDeviceIsThatOfTheHost)
{
    std::set<uint64_t> hashes;
    for (const uint32_t count : {1u, 31u, 32u, 33u, 2049u, 5003u}) {
        const World world = grains(count);
        Solver solver(gpu(), world);
        solver.step();
        solver.checkCounters(1);
        const uint64_t hash = solver.stateHash();
        EXPECT_EQ(hash, stateHash(solver.readView())) << count;
        EXPECT_EQ(hash, solver.stateHash()) << "a second time";
        hashes.insert(hash);
    }
    EXPECT_EQ(hashes.size(), 6u);
}

TEST(StateHash, ChangesWithEveryBitAndPlace)
{
    const World world = grains(3);
    Solver solver(gpu(), world);
    const ViewState view = solver.readView();
    std::set<uint64_t> hashes{stateHash(view)};
    size_t count = 1;
    for (auto member : {&ViewState::positions, &ViewState::velocities})
        for (size_t particle = 0; particle < 3; ++particle)
            for (auto component : {&gpu::vec4::x, &gpu::vec4::y, &gpu::vec4::z})
                for (uint32_t bit = 0; bit < 32; ++bit, ++count) {
                    ViewState changed = view;
                    float& value = (changed.*member)[particle].*component;
                    value = std::bit_cast<float>(std::bit_cast<uint32_t>(value) ^ 1u << bit);
                    hashes.insert(stateHash(changed));
                }
    ViewState exchanged = view;
    std::swap(exchanged.positions[0], exchanged.positions[1]);
    hashes.insert(stateHash(exchanged));
    EXPECT_EQ(hashes.size(), count + 1);
}

}  // namespace
}  // namespace knuckle::test
