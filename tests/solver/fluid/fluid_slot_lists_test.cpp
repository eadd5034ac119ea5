#include <algorithm>

#include "shared/slot_lists.h"
#include "tests/solver/fluid/fluid_fixture.h"

namespace knuckle::test {

namespace {

/// 1033 particles, of which a third list solids, a third are near a collider, and a third are free.
class FluidSlotLists : public testing::Test {
protected:
    FluidSlotLists()
    {
        fixture.findNeighbours();
        for (uint32_t i = 0; i < fixture.count(); ++i) colliders.push_back(i % 3 == 1 ? 2 : 0);
        for (uint32_t k = 0; k < fixture.count(); ++k)
            if (fixture.slotParticles[k] % 3 != 0) fixture.slotCounts[k].y = 0;
        FluidStage& f = *fixture.stages.fluids;
        fill(f.slotCounts, fixture.slotCounts);
        fill(f.slotColliders, fixture.inSlots(colliders));
        fill(f.slotListSizes, std::vector<gpu::uvec4>(SLOT_LISTS, {0, 1, 1, 0}));
        fixture.forSlots("fluid/walls/fluid_slot_lists");
        sizes = f.slotListSizes.download();
    }
    /// FREE_SLOTS_SIZE, ...; SLOT_LISTS for none.
    uint32_t listOf(uint32_t slot) const
    {
        const uint32_t i = fixture.slotParticles[slot];
        if (!fixture.isFluid(i)) return SLOT_LISTS;
        if (fixture.slotCounts[slot].y > 0) return COVERED_SLOTS_SIZE;
        return colliders[i] != 0 ? WALLED_SLOTS_SIZE : FREE_SLOTS_SIZE;
    }
    /// The first `size` entries, sorted.
    std::vector<uint32_t> listed(const Buffer<uint32_t>& list, uint32_t size) const
    {
        auto found = list.download();
        found.resize(size);
        std::sort(found.begin(), found.end());
        return found;
    }

    FluidFixture fixture;
    std::vector<uint32_t> colliders;
    std::vector<gpu::uvec4> sizes;
};

TEST_F(FluidSlotLists, EachFluidSlotStandsInOneList)
{
    const FluidStage& f = *fixture.stages.fluids;
    const Buffer<uint32_t>* lists[SLOT_LISTS] = {&f.freeSlots, &f.walledSlots, &f.coveredSlots};
    for (uint32_t list = 0; list < SLOT_LISTS; ++list) {
        std::vector<uint32_t> wanted;
        for (uint32_t k = 0; k < fixture.count(); ++k)
            if (listOf(k) == list) wanted.push_back(k);
        EXPECT_GT(wanted.size(), GROUP_SIZE) << list;
        ASSERT_EQ(sizes[list].w, wanted.size()) << list;
        EXPECT_EQ(sizes[list].x, (wanted.size() + GROUP_SIZE - 1) / GROUP_SIZE) << list;
        EXPECT_EQ(listed(*lists[list], sizes[list].w), wanted) << list;
    }
}

TEST_F(FluidSlotLists, PressuresAreTheSameWhateverListASlotIsIn)
{
    FluidStage& f = *fixture.stages.fluids;
    Random random(53);
    std::vector<gpu::vec4> moves, pasts;
    for (uint32_t i = 0; i < fixture.count(); ++i) {
        moves.push_back(packed(random.inCube(0.004f)));
        moves.back().w = fixture.isFluid(i) ? 0.0f : -fixture.packedTurn(i).y;
        pasts.push_back({0, 0, 0, random.between(0.0f, 0.1f)});
    }
    fill(f.slotMoves, fixture.inSlots(moves));
    fill(f.slotVelocities, std::vector<gpu::vec4>(fixture.count()));
    fixture.forSlots("fluid/pressure/fluid_shape");
    const auto moved = [&](const std::vector<const char*>& lists) {
        fill(f.fluidPasts, pasts);
        fill(f.slotPressures, std::vector<gpu::uvec4>(2 * fixture.count()));
        fill(f.slotSolidImpulses, std::vector<gpu::vec4>(fixture.count()));
        fill(fixture.stages.particles.positions, fixture.places);
        fill(fixture.stages.particles.velocities, std::vector<gpu::vec4>(fixture.count()));
        const auto slotPositions = f.slotPositions.download();
        for (const char* kernel : {"fluid/pressure/fluid_density", "fluid/pressure/fluid_pressure"})
            for (const char* list : lists) fixture.forSlots(kernel, *list != 0 ? Defines{{list, "1"}} : Defines{});
        fill(f.slotPositions, slotPositions);
        fill(f.slotMoves, fixture.inSlots(moves));
        return fixture.stages.particles.positions.download();
    };
    const auto all = moved({""}), apart = moved({"FREE", "WALLED", "COVERED"});
    double size = 0.0;
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) {
        // Of what is not near, nothing is added: only the order of sums may differ.
        ASSERT_LT((vec3(all[i]) - vec3(apart[i])).norm(), 1e-6f) << i;
        size += (vec3(all[i]) - vec3(fixture.places[i])).norm();
    }
    EXPECT_GT(size / fixture.parameters().fluidCount, 1e-4);
}

}  // namespace

}  // namespace knuckle::test
