#include <gtest/gtest.h>

#include <cstdlib>

#include "app/run/shell_command.h"

namespace knuckle::test {
namespace {

TEST(ShellCommand, HasItsOwnVariablesInPlaceOfInheritedOnes)
{
    setenv("KNUCKLE_TEST_WORD", "inherited", 1);
    EXPECT_EQ(runShell("echo $KNUCKLE_TEST_WORD", "").output, "inherited\n");
    EXPECT_EQ(runShell("echo $KNUCKLE_TEST_WORD", "", {"KNUCKLE_TEST_WORD=own"}).output, "own\n");
    unsetenv("KNUCKLE_TEST_WORD");
}

TEST(ShellCommand, SaysHowItEnded)
{
    EXPECT_EQ(runShell("true", "").failure, "");
    EXPECT_EQ(runShell("echo a; echo b >&2; exit 3", "").failure, "failed with exit code 3");
    EXPECT_EQ(runShell("echo a; echo b >&2; exit 3", "").lastLine, "b");
    EXPECT_EQ(runShell("kill -9 $$", "").failure, "was ended by signal 9");
}

TEST(ShellCommand, QuotesWords)
{
    for (const std::string word : {"plain/word-1.png", "two words", "it's", "$HOME", "", "*"})
        EXPECT_EQ(runShell("printf %s " + quotedForShell(word), "").output, word);
    EXPECT_EQ(quotedForShell("plain/word-1.png"), "plain/word-1.png");
}

}  // namespace
}  // namespace knuckle::test
