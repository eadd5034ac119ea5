#include "app/serve/web/access.h"

#include <gtest/gtest.h>

#include "app/serve/web/inbox.h"
#include "app/serve/web/latest.h"

namespace knuckle {
namespace {

TEST(Serve, KnowsThisMachineFromOthersThatSoundAlike)
{
    for (const char* own : {"localhost", "127.0.0.1", "127.1.2.3", "::1"}) EXPECT_TRUE(isLoopback(own)) << own;
    for (const char* other : {"", "0.0.0.0", "::", "127.0.0.1.example.org", "localhost.example.org", "10.0.0.1"})
        EXPECT_FALSE(isLoopback(other)) << other;
    EXPECT_EQ(nameOfHost("localhost:8080"), "localhost");
    EXPECT_EQ(nameOfHost("[::1]:8080"), "::1");
    EXPECT_EQ(nameOfHost("127.0.0.1"), "127.0.0.1");
}

TEST(Serve, AnswersPagesOfItsOwnSiteAlone)
{
    EXPECT_TRUE(isOwnOrigin("", "localhost:8080"));
    EXPECT_TRUE(isOwnOrigin("http://localhost:8080", "localhost:8080"));
    for (const char* other :
         {"null", "http://localhost:8081", "http://example.org", "http://localhost:8080.example.org"})
        EXPECT_FALSE(isOwnOrigin(other, "localhost:8080")) << other;
    for (const char* own : {"", "same-origin", "none"}) EXPECT_FALSE(isOfAnotherSite(own)) << own;
    for (const char* other : {"cross-site", "same-site"}) EXPECT_TRUE(isOfAnotherSite(other)) << other;
}

TEST(Serve, TakesTheWholeSecretAlone)
{
    EXPECT_TRUE(isSameSecret("secret", "secret"));
    for (const char* other : {"", "s", "secre", "secrets", "secretsecret", "Secret"})
        EXPECT_FALSE(isSameSecret(other, "secret")) << other;
}

TEST(Serve, TakesSoManyInputsAtOnceAndNoMore)
{
    Inbox inbox;
    size_t taken = 0;
    for (int k = 0; k < 1000; ++k) taken += inbox.put({}) ? 1 : 0;
    EXPECT_GE(taken, static_cast<size_t>(Inbox::MOST_A_SECOND));
    EXPECT_LE(taken, Inbox::MOST_WAITING);
    EXPECT_EQ(inbox.take().size(), taken);
}

TEST(Serve, ShowsOnlyTheNewest)
{
    Latest latest;
    EXPECT_EQ(latest.next(0, std::chrono::milliseconds(1)).bytes, nullptr);
    latest.put("first");
    latest.put("second");
    const Latest::Shown shown = latest.next(0, std::chrono::milliseconds(1));
    EXPECT_EQ(*shown.bytes, "second");
    EXPECT_EQ(latest.next(shown.number, std::chrono::milliseconds(1)).number, shown.number) << "again";
    latest.close();
    EXPECT_TRUE(latest.isClosed());
}

}  // namespace
}  // namespace knuckle
