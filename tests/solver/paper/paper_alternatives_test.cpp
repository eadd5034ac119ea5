#include <fmt/format.h>

#include <set>

#include "app/bench/bench_worlds.h"
#include "sim/solver/solver.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

constexpr int ROWS = 12;
constexpr uint32_t PAIRS = 12;
constexpr int STEPS = 150;

/// A Plackett-Burman design of twelve rows: any two columns have all four pairs of levels. The columns used below also
/// meet all values of the rows modulo three.
bool level(int row, int column)
{
    static constexpr const char* FIRST = "++-+++---+-";
    return row < ROWS - 1 && FIRST[(row + 11 - column) % 11] == '+';
}

/// The alternatives of a row: any two values of two different settings meet in some row.
Settings rowOf(SolverKind solver, int row)
{
    Settings s = paperSettings();
    s.solver = solver;
    s.rotation = static_cast<RotationMethod>(row % 3);
    s.reduction = static_cast<ReductionKind>(1 + row / 3 % 3);
    s.grid = level(row, 1) ? GridKind::Hash : GridKind::Lattice;
    s.velocityOrder = level(row, 2) ? VelocityOrder::First : VelocityOrder::Second;
    s.splitSharedMass = level(row, 4);
    s.freeze = level(row, 5) ? 0.5f : 0.0f;
    s.virtualParticles = level(row, 7) ? 0.01f : 0.0f;
    if (solver == SolverKind::Paper) return s;
    s.reduction = ReductionKind::Auto;
    s.stabilization = 0;
    s.iterations = 2;
    s.massScaling = 0.0f;
    return s;
}

std::vector<int> levelsOf(const Settings& s)
{
    return {int(s.rotation),
            int(s.reduction),
            int(s.grid),
            int(s.velocityOrder),
            int(s.splitSharedMass),
            int(s.freeze > 0.0f),
            int(s.virtualParticles > 0.0f)};
}

class Alternatives : public testing::TestWithParam<std::tuple<SolverKind, int>> {};

TEST_P(Alternatives, AShortPileIsRigidShutAndCalm)
{
    const auto [solver, row] = GetParam();
    const World world = table2World(PAIRS, rowOf(solver, row));
    Solver run(gpu(), world);
    for (int k = 0; k < STEPS; ++k) {
        run.step();
        run.checkCounters(static_cast<uint64_t>(k));
    }
    const Measures m = run.measure();
    const float d = world.diameter();
    EXPECT_LT(m.worstShapeError, 1e-3f * d);
    EXPECT_LT(m.meanJointGap, 0.05f * d);
    EXPECT_LT(m.worstJointGap, 0.5f * d);
    EXPECT_LT(m.meanPenetration, 0.1f * d);
    EXPECT_LT(m.maxSpeed, 0.5f);
    for (const BodyState& body : run.readBodies()) EXPECT_GT(body.position.y(), 0.0f);
}

std::string rowName(const testing::TestParamInfo<std::tuple<SolverKind, int>>& test)
{
    return fmt::format("{}{}", std::get<0>(test.param) == SolverKind::Paper ? "Paper" : "Impulse",
                       std::get<1>(test.param));
}

INSTANTIATE_TEST_SUITE_P(Rows, Alternatives,
                         testing::Combine(testing::Values(SolverKind::Impulse, SolverKind::Paper),
                                          testing::Range(0, ROWS)),
                         rowName);

TEST(AlternativeRows, EveryTwoValuesMeet)
{
    const std::vector<size_t> counts = {3, 3, 2, 2, 2, 2, 2};
    for (size_t a = 0; a < counts.size(); ++a)
        for (size_t b = a + 1; b < counts.size(); ++b) {
            std::set<std::pair<int, int>> met;
            for (int row = 0; row < ROWS; ++row) {
                const std::vector<int> levels = levelsOf(rowOf(SolverKind::Paper, row));
                met.insert({levels[a], levels[b]});
            }
            EXPECT_EQ(met.size(), counts[a] * counts[b]) << "settings " << a << " and " << b;
        }
}

}  // namespace

}  // namespace knuckle::test
