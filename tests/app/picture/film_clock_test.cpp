#include <gtest/gtest.h>

#include "app/scene/picture/film_clock.h"

namespace knuckle {
namespace {

void expectPlace(const FilmClock& clock, uint64_t frame, uint64_t steps, double part)
{
    const FramePlace place = clock.at(frame);
    EXPECT_EQ(place.steps, steps) << "frame " << frame;
    EXPECT_NEAR(place.part, part, 1e-9) << "frame " << frame;
}

TEST(FilmClock, TakesAsManyStepsAFrameAtFullSpeed)
{
    const FilmClock clock(24000.0 / 1001.0, 3, {{.from = 0}, {.from = 1}});
    EXPECT_TRUE(clock.isEven());
    for (const uint64_t frame : {1u, 2u, 25u, 100000u}) expectPlace(clock, frame, 3 * (frame - 1), 1.0);
    EXPECT_TRUE(clock == FilmClock(24000.0 / 1001.0, 3, {}));
}

TEST(FilmClock, ShowsFourFramesAStepAtAQuarterOfTheSpeed)
{
    const FilmClock clock(60, 1, {{.from = 0}, {.from = 0.5, .timeScale = 0.25f}, {.from = 1}});
    EXPECT_FALSE(clock.isEven());
    expectPlace(clock, 30, 29, 1.0);
    expectPlace(clock, 31, 30, 1.0);  // the first frame of the shot, at 0.5 s
    expectPlace(clock, 32, 31, 0.25);
    expectPlace(clock, 33, 31, 0.5);
    expectPlace(clock, 34, 31, 0.75);
    expectPlace(clock, 35, 31, 1.0);
    expectPlace(clock, 36, 32, 0.25);
    expectPlace(clock, 61, 38, 0.5);  // the first at full speed
    expectPlace(clock, 62, 39, 0.5);
}

TEST(FilmClock, TakesMoreStepsAFrameInFastMotion)
{
    const FilmClock clock(60, 2, {{.from = 0}, {.from = 0.5, .timeScale = 1.25f}, {.from = 1, .timeScale = 20}});
    EXPECT_FALSE(clock.isEven());
    expectPlace(clock, 31, 60, 1.0);
    expectPlace(clock, 32, 63, 0.5);
    expectPlace(clock, 33, 65, 1.0);
    expectPlace(clock, 61, 135, 1.0);
    expectPlace(clock, 62, 175, 1.0);
}

TEST(FilmClock, TakesFewerStepsAFrameWhereThereAreMany)
{
    const FilmClock clock(60, 4, {{.from = 0, .timeScale = 0.25f}});
    for (const uint64_t frame : {1u, 2u, 3u, 77u}) expectPlace(clock, frame, frame - 1, 1.0);
}

TEST(FilmClock, StandsStillAtTheStateOfTheCut)
{
    const FilmClock clock(30, 2, {{.from = 0}, {.from = 1, .timeScale = 0}, {.from = 2}});
    expectPlace(clock, 31, 60, 1.0);
    expectPlace(clock, 60, 60, 1.0);
    expectPlace(clock, 61, 60, 1.0);
    expectPlace(clock, 62, 62, 1.0);
}

TEST(FilmClock, CutsAtTheFirstFrameAtTheTimeOrAfter)
{
    const std::vector<Shot> shots{{.from = 0}, {.from = 0.51, .timeScale = 0}};
    expectPlace(FilmClock(60, 1, shots), 31, 30, 1.0);
    expectPlace(FilmClock(60, 1, shots), 32, 31, 1.0);
    expectPlace(FilmClock(60, 1, shots), 33, 31, 1.0);
    EXPECT_EQ(shotAt(shots, 30 / 60.0), 0u);
    EXPECT_EQ(shotAt(shots, 31 / 60.0), 1u);
    EXPECT_EQ(shotAt(shots, 0.51), 1u);
}

}  // namespace
}  // namespace knuckle
