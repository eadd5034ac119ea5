#include <cmath>

#include "tests/physics/rope/capstan_fixture.h"

namespace knuckle::test {

namespace {

using Way = Capstan::Way;

/// Loads of 20 and 48 kg on 4 cm of 480 g/m, and of 10,000 of a rope's particles.
constexpr float LOAD = 20.0f, CORD = 0.48f, LIGHT = 0.12f;

class CapstanAt : public testing::TestWithParam<uint32_t> {
protected:
    Capstan with(Way way, float friction, float left, float right, float massPerLength = LIGHT) const
    {
        return {.way = way,
                .substeps = GetParam(),
                .friction = friction,
                .left = left,
                .right = right,
                .massPerLength = massPerLength};
    }
};

/// Neither sinks in nor stretches, and gains nothing.
void expectSound(const CapstanRun& run)
{
    EXPECT_LT(run.sunk, 0.1 * Capstan::THICKNESS);
    EXPECT_LT(run.stretched, 0.01 * 2.69);  // its least length
    EXPECT_LT(run.gained, 0.01);
}

/// What the rope bears on one side over the other when it slides: e^(mu phi), for links that turn by `link` each.
double eulersRatio(const Capstan& c)
{
    const double link = c.angle() / std::ceil(c.angle() * 1.01 * (Capstan::RADIUS + 0.02) / 0.03996);
    return std::exp(c.angle() * 2 * std::atanh(c.friction * std::tan(0.5 * link)) / link);
}

/// (m1 - m2 e^(mu phi)) g / (m1 + m2 e^(mu phi)), the acceleration of two loads with what hangs of the rope [m/s2].
double acceleration(const Capstan& c)
{
    const double hanging = c.massPerLength * c.hang, held = (c.right + hanging) * eulersRatio(c);
    return GRAVITY * (c.left + hanging - held) / (c.left + hanging + held);
}

/// The left load that is `part` of what would slide.
Capstan loaded(Capstan c, double part)
{
    const double hanging = c.massPerLength * c.hang;
    c.left = static_cast<float>(part * eulersRatio(c) * (c.right + hanging) - hanging);
    return c;
}

}  // namespace

TEST_P(CapstanAt, SticksBelowEulersRatio)
{
    for (const Capstan& c :
         {loaded(with(Way::Half, 0.3f, 0, LOAD), 0.95), loaded(with(Way::Half, 0.3f, 0, LOAD, CORD), 0.95),
          loaded(with(Way::Corners, 0.3f, 0, LOAD), 0.95), loaded(with(Way::Wound, 0.3f, 0, 3.0f), 0.95)}) {
        const CapstanRun run = runCapstan(c, 2.0);
        expectSound(run);
        // It gives by the drag that holds it, of a load's mass h (StrandStage): by mu g h times the part of a turn in a
        // link, 0.18, on average over the drum; 2 mm/s at 4 substeps, and more where the rope has yet to settle.
        EXPECT_LT(std::abs(run.moved - run.between), 4e-3);
    }
}

TEST_P(CapstanAt, SlidesAboveEulersRatio)
{
    for (const Capstan& c :
         {loaded(with(Way::Half, 0.3f, 0, LOAD), 1.05), loaded(with(Way::Wound, 0.3f, 0, 3.0f), 1.05)}) {
        const CapstanRun run = runCapstan(c, 1.0);
        expectSound(run);
        // Loads a twentieth apart leave an acceleration of a fortieth of g: one per cent of friction is a fifth of it.
        // It starts with no tension, and is on its way before friction holds it.
        EXPECT_GT(run.moved, 0.6 * 0.5 * acceleration(c));
        EXPECT_LT(run.moved, 1.5 * 0.5 * acceleration(c));
    }
}

TEST_P(CapstanAt, AcceleratesAsTheClosedFormSays)
{
    constexpr double TIME = 0.5;
    for (const Capstan& c : {with(Way::Half, 0.3f, 5 * LOAD, LOAD), with(Way::Half, 0.5f, 7.5f * LOAD, LOAD, CORD),
                             with(Way::Corners, 0.2f, 4 * LOAD, LOAD), with(Way::Wound, 0.2f, 48.0f, 3.0f)}) {
        const CapstanRun run = runCapstan(c, TIME);
        expectSound(run);
        // The rope is 1 to 2 % of the loads.
        EXPECT_NEAR(run.moved, 0.5 * acceleration(c) * TIME * TIME, 0.05 * 0.5 * acceleration(c) * TIME * TIME)
            << c.friction << ", " << c.left << " : " << c.right;
    }
}

TEST_P(CapstanAt, WithoutFrictionIsAtwoodsMachine)
{
    constexpr double TIME = 0.6;
    for (const Way way : {Way::Half, Way::Corners}) {
        const Capstan c = with(way, 0.0f, 1.5f * LOAD, LOAD);
        const CapstanRun run = runCapstan(c, TIME);
        expectSound(run);
        const double way0 = 0.5 * acceleration(c) * TIME * TIME;
        EXPECT_NEAR(run.moved, way0, 0.02 * way0);
    }
}

TEST_P(CapstanAt, CarriesBoxesThatSwing)
{
    for (const float massPerLength : {CORD, LIGHT}) {
        if (massPerLength == LIGHT && GetParam() < 10) continue;  // sinks in by 13 % of its thickness
        Capstan c = with(Way::Half, 0.3f, 48.0f, LOAD, massPerLength);
        c.boxes = true;
        c.swing = 1.5f;
        expectSound(runCapstan(c, 2.0));
    }
}

INSTANTIATE_TEST_SUITE_P(Capstan, CapstanAt, testing::Values(4u, 10u, 32u));

}  // namespace knuckle::test
