#include "app/serve/pace.h"

#include <gtest/gtest.h>

#include <thread>

#include "app/serve/picture_share.h"

namespace knuckle {
namespace {

TEST(Serve, GivesPicturesLittleWhereStepsAreLateAndAllWhereTheyAreNot)
{
    PictureShare share(0.1);
    EXPECT_EQ(share.now(), 0.1);
    for (int k = 0; k < 200; ++k) share.note(false);
    EXPECT_EQ(share.now(), 1.0);
    for (int k = 0; k < 5; ++k) share.note(true);
    EXPECT_LT(share.now(), 0.5);
    for (int k = 0; k < 20; ++k) share.note(true);
    EXPECT_EQ(share.now(), 0.1);
    share.setLeast(0.3);
    share.note(true);
    EXPECT_EQ(share.now(), 0.3);
}

TEST(Serve, KnowsWhenStepsAreLate)
{
    Pace pace(0.01);
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    EXPECT_GE(pace.due(), 1u);
    pace.took(1, 0.2);  // so that one step is all that fits
    EXPECT_FALSE(pace.isBehind());
    for (int k = 0; k < 3; ++k) {
        std::this_thread::sleep_for(std::chrono::milliseconds(40));
        EXPECT_EQ(pace.due(), 1u);
    }
    EXPECT_TRUE(pace.isBehind());
    pace.begin(0.02);
    EXPECT_FALSE(pace.isBehind());
    EXPECT_EQ(pace.stepSeconds(), 0.0);
}

}  // namespace
}  // namespace knuckle
