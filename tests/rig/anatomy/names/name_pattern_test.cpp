#include <gtest/gtest.h>

#include "sim/rig/anatomy/names/name_pattern.h"

namespace knuckle {

TEST(NamePatterns, StarsStandForAnyLettersQuestionMarksForOne)
{
    for (const char* pattern : {"LeftArm", "*", "Left*", "*Arm", "L*t*m", "LeftAr?", "*f*A*", "Left*Arm", "**"})
        EXPECT_TRUE(matchesPattern("LeftArm", pattern)) << pattern;
    for (const char* pattern : {"leftArm", "Left", "Arm*", "Left?Arm", "*Arms", "", "LeftArm?", "*g*"})
        EXPECT_FALSE(matchesPattern("LeftArm", pattern)) << pattern;
    EXPECT_TRUE(matchesPattern("", "*"));
    EXPECT_TRUE(matchesPattern("aaaaaaaaaaaaaaaaaaaaaaab", "*a*a*a*a*a*b"));
}

TEST(NamePatterns, TheNameItselfWinsThenTheLongestPattern)
{
    const std::map<std::string, int> entries{{"*", 1},      {"tail*", 2},  {"tail0*", 3},
                                             {"tail03", 4}, {"t?il03", 6}, {"***l05", 5}};
    EXPECT_EQ(*findByPattern(entries, "tail03"), 4);
    EXPECT_EQ(*findByPattern(entries, "tail02"), 3);
    EXPECT_EQ(*findByPattern(entries, "tail12"), 2);
    EXPECT_EQ(*findByPattern(entries, "wing"), 1);
    EXPECT_EQ(findByPattern(std::map<std::string, int>{{"tail*", 2}}, "wing"), nullptr);
}

}  // namespace knuckle
