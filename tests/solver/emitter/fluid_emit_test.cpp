#include <cmath>

#include "tests/solver/emitter/emitter_fixture.h"

namespace knuckle::test {

namespace {

class FluidEmit : public testing::Test {
protected:
    static constexpr uint32_t IN_FRONT = 18;

    FluidEmit()
    {
        fixture.shuffle(451);
        fixture.deactivate(0.8f, 452);
        // Of several layers, so that some meet existing particles.
        states.resize(3);
        const uint32_t layers[] = {3, 1, 5};
        uint32_t candidates = 0;
        for (uint32_t k = 0; k < 3; ++k) {
            states[k].taken = layers[k] * fixture.pointCount(k);
            states[k].firstCandidate = candidates;
            states[k].age = 0.37f * static_cast<float>(fixture.emitter(k).interval());
            candidates += states[k].taken;
        }
        candidates_ = candidates;
        // Fluid just in front of some of the nozzles' points.
        for (uint32_t j = 0; j < IN_FRONT; ++j) {
            const Emitter& e = fixture.emitter(j % 3);
            const Vector3f nozzle = e.nozzle.points[j % e.nozzle.points.size()];
            fixture.positions[fixture.solidCount() + j] = packed(Vector3f(nozzle + states[j % 3].age * e.velocity));
        }
        fixture.setStates(states);
        // They go to the end of the list, and wait.
        for (uint32_t k = 0; k < 3; ++k)
            for (uint32_t q = 0; q < states[k].taken; ++q) fixture.positions[particleOf(k, q)].w = 1;
        fillGrid();
    }
    uint32_t particleOf(uint32_t k, uint32_t q) const
    {
        const uint32_t place = fixture.poolStart(k) + fixture.emitter(k).pool - states[k].taken + q;
        return fixture.order[fixture.after() + place];
    }
    /// Cells have the places at the start of the step.
    void fillGrid()
    {
        auto old = fixture.positions;
        Random random(453);
        for (gpu::vec4& p : old) p = packed(Vector3f(vec3(p) + random.inCube(0.01f)), p.w);
        // Half of those in front of the nozzles have been taken back since.
        for (uint32_t j = 0; j < IN_FRONT; j += 2) fixture.positions[fixture.solidCount() + j].w = 1;
        fill(fixture.stages.fluids->fluidSearchPositions, old);
        fill(fixture.stages.particles.positions, fixture.positions);
        const auto count = static_cast<uint32_t>(old.size());
        uint32_t active = 0;  // of those that have a slot
        for (const gpu::vec4& p : old) active += p.w == 0.0f;
        fixture.setTotals(active - fixture.solidCount() - fixture.stages.parameters.fluidFilled, 0);
        const Defines fluids{{"FLUIDS", "1"}};
        const uint32_t cells = fixture.stages.parameters.fluidCellMask + 1;
        fixture.runPools("common/grid/grid_count", count, fluids);
        fixture.run("common/grid/scan_sum", cells / SCAN_CHUNK, fluids);
        fixture.run("common/grid/grid_start", cells / SCAN_CHUNK, fluids);
        fixture.runPools("common/grid/grid_scatter", count, fluids);
        fixture.runPools("fluid/fluid_order", count, fluids);
    }
    /// The excess of room at x over what a particle needs [m], among all present.
    double room(uint32_t k, const Vector3d& x) const
    {
        const Nozzle& nozzle = fixture.emitter(k).nozzle;
        const double spacing = fixture.world.fluidSpacing;
        const double ofFluid = 0.25 * std::min({double(nozzle.pitch), double(nozzle.layerSpacing), spacing});
        double least = 1e9;
        for (uint32_t i = 0; i < fixture.positions.size(); ++i) {
            if (fixture.positions[i].w != 0.0f) continue;
            const double away = (vec3(fixture.positions[i]).cast<double>() - x).norm();
            least = std::min(least, away - (i < fixture.solidCount() ? 0.45 * (DIAMETER + spacing) : ofFluid));
        }
        return least;
    }

    EmitterFixture fixture;
    std::vector<gpu::EmitterState> states;
    uint32_t candidates_ = 0;
};

TEST_F(FluidEmit, EachParticleStartsWhereItHasComeToSinceItsLayerLeftUnlessSomethingStandsThere)
{
    const uint32_t before = fixture.totals()[0];
    fixture.runPools("emitter/fluid_emit", candidates_, {{"FLUIDS", "1"}});
    const auto positions = fixture.stages.particles.positions.download();
    const auto velocities = fixture.stages.particles.velocities.download();
    const Vector3d gravity = vec3(fixture.stages.parameters.gravity).cast<double>();
    const double h = fixture.stages.parameters.substepTime;
    uint32_t came = 0, kept = 0, edges = 0;
    for (uint32_t k = 0; k < 3; ++k) {
        const Emitter& e = fixture.emitter(k);
        const uint32_t points = fixture.pointCount(k);
        for (uint32_t q = 0; q < states[k].taken; ++q) {
            SCOPED_TRACE("emitter " + std::to_string(k) + ", its particle " + std::to_string(q));
            const uint32_t later = (states[k].taken - 1) / points - q / points, i = particleOf(k, q);
            const double t = states[k].age + later * e.interval();
            const Vector3d velocity = e.velocity.cast<double>();
            // Symplectic Euler, as the solver's substeps: speed first.
            const Vector3d x = e.nozzle.points[q % points].cast<double>() + t * velocity + 0.5 * t * (t + h) * gravity;
            edges += std::abs(room(k, x)) < 1e-6;
            const bool comes = room(k, x) > 0.0;
            came += comes;
            kept += !comes;
            ASSERT_EQ(positions[i].w, comes ? 0.0f : 1.0f);
            if (!comes) {
                EXPECT_EQ(vec3(positions[i]), vec3(fixture.positions[i]));
                EXPECT_EQ(vec3(velocities[i]), vec3(fixture.velocities[i]));
                continue;
            }
            // Places of up to a metre and speeds of up to 13 m/s, rounded a few times.
            EXPECT_LT((vec3(positions[i]).cast<double>() - x).norm(), 5e-7);
            EXPECT_LT((vec3(velocities[i]).cast<double>() - velocity - t * gravity).norm(), 4e-6);
            EXPECT_NEAR(velocities[i].w, std::max(e.interval() - t, 0.0), 1e-8);
        }
    }
    EXPECT_EQ(edges, 0u);
    EXPECT_GT(came, 20u);
    EXPECT_GT(kept, 10u);
    EXPECT_EQ(fixture.totals()[0], before + came);
}

}  // namespace

}  // namespace knuckle::test
