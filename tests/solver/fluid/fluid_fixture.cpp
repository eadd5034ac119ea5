#include "tests/solver/fluid/fluid_fixture.h"

#include <cmath>

#include "sim/solver/fluid/fluid_numbers.h"

namespace knuckle::test {

namespace {

constexpr uint32_t COUNT = 1033, SLOTS = 200;
constexpr float HALF = 0.25f;
constexpr float TURN_STEPS = 2047.0f;

World fluidWorld(const Settings& settings)
{
    WorldBuilder builder(DIAMETER / 2, settings);
    Material solid, water, oil;
    solid.density = 700.0f;
    water.fluid = oil.fluid = true;
    water.density = 1000.0f;
    oil.density = 400.0f;
    oil.viscosity = 2.0f;
    builder.addMaterial(solid);
    const uint32_t fluids[] = {builder.addMaterial(water), builder.addMaterial(oil)};
    for (const Eigen::Vector3i& counts : {Eigen::Vector3i(4, 3, 3), {5, 1, 4}}) {
        builder.beginObject("body");
        builder.addBody("body", boxLattice(counts, DIAMETER), 0);
        builder.endObject();
    }
    for (int k = 0; k < 30; ++k) builder.addLooseParticle({});
    builder.addCollider(planeAt({0, -HALF, 0}, {0, 1, 0}));
    builder.addCollider(planeAt({HALF, 0, 0}, {-1, 0, 0}));
    // Far from the solids, for none to be left out.
    for (uint32_t k = builder.particleCount(); k < COUNT; ++k) {
        const Vector3f place(5.0f + 0.1f * static_cast<float>(k), 0, 0);
        builder.addFluid(std::span(&place, 1), {0, 0, 0}, fluids[k % 2]);
    }
    return builder.build();
}

}  // namespace

FluidFixture::FluidFixture(const Settings& settings) : KernelFixture(fluidWorld(settings))
{
    stages.parameters.fluidSlots = SLOTS;
    stages.fluids->makeLists();
    wrap(false);
    masses = stages.particles.masses.download();
    setPlaces(randomVectors(count(), HALF, 31));
    Random random(32);
    for (uint32_t i = 0; i < solidCount(); ++i) {
        Quaternionf turn = random.rotation();
        if (turn.w() < 0.0f) turn.coeffs() = -turn.coeffs();
        for (int k = 0; k < 3; ++k) turn.coeffs()[k] = std::round(turn.coeffs()[k] * TURN_STEPS) / TURN_STEPS;
        turn.w() = std::sqrt(std::max(1.0f - turn.vec().squaredNorm(), 0.0f));
        turns.push_back(turn);
    }
}

gpu::vec4 FluidFixture::packedTurn(uint32_t particle) const
{
    const Vector3f t = (turns[particle].vec() * TURN_STEPS).array().round() + 2048.0f;
    return {4096.0f * t.x() + t.y(), t.z(), 0, 0};
}

void FluidFixture::setPlaces(const std::vector<gpu::vec4>& positions)
{
    places = positions;
    fill(stages.fluids->fluidSearchPositions, places);
    fill(stages.particles.positions, places);
}

void FluidFixture::wrap(bool early)
{
    // The place spans six cells; packed places repeat after four.
    stages.parameters.fluidStrideY = (early ? 4 : 10) * FINE_CELLS;
    stages.parameters.fluidStrideZ = 10 * stages.parameters.fluidStrideY;
    setParameters();
}

void FluidFixture::findNeighbours()
{
    const Defines defines{{"FLUIDS", "1"}};
    const uint32_t cells = parameters().fluidCellMask + 1;
    forSlots("common/grid/grid_count", defines);
    run("common/grid/scan_sum", cells / SCAN_CHUNK, defines);
    run("common/grid/grid_start", cells / SCAN_CHUNK, defines);
    for (const char* kernel : {"common/grid/grid_scatter", "fluid/fluid_order"}) forSlots(kernel, defines);
    stages.fluids->fluidNearSolids.clear();
    run("fluid/fluid_near_solids", solidCount(), defines);
    forSlots("fluid/fluid_find", {{"FLUIDS", "1"}, {"SOLIDS", "1"}});
    FluidStage& f = *stages.fluids;
    slotParticles = f.slotParticles.download();
    slotCounts = f.slotCounts.download();
    neighbours.clear();
    for (const gpu::uvec4& four : f.slotNeighbours.download())
        neighbours.insert(neighbours.end(), {four.x, four.y, four.z, four.w});
    auto slotPositions = places;
    for (uint32_t i = 0; i < count(); ++i)
        slotPositions[i].w = isFluid(i) ? static_cast<float>(mass(i)) : packedTurn(i).x;
    fill(f.slotPositions, inSlots(slotPositions));
    fill(f.slotColliders, std::vector<uint32_t>(count(), 0));
}

uint32_t FluidFixture::entry(uint32_t slot, uint32_t n) const
{
    const uint32_t block = slot / NEIGHBOUR_BLOCK, fours = parameters().fluidSlots / 4;
    return neighbours.at(4 * ((block * fours + n / 4) * NEIGHBOUR_BLOCK + slot % NEIGHBOUR_BLOCK) + n % 4);
}

std::vector<uint32_t> FluidFixture::near(uint32_t particle, bool fluid, double reach) const
{
    std::vector<uint32_t> found;
    for (uint32_t j = fluid ? solidCount() : 0; j < (fluid ? count() : solidCount()); ++j)
        if (j != particle && (place(particle) - place(j)).norm() < reach) found.push_back(j);
    return found;
}

double FluidFixture::share(double r) const
{
    const double q = r / parameters().fluidReach;
    return q < 1.0 ? parameters().fluidVolume * std::pow(1.0 - q, 4) * (1.0 + 4.0 * q) : 0.0;
}

}  // namespace knuckle::test
