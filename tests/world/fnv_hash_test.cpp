#include "sim/base/fnv_hash.h"

#include <gtest/gtest.h>

#include <string>

namespace knuckle::test {

/// Uses the published value for "foobar".
TEST(FnvHash, TakesWordsFromTheLeastSignificantByteOn)
{
    FnvHash bytes, words;
    for (const char letter : std::string("foobar")) bytes.add(static_cast<uint8_t>(letter));
    words.add(uint32_t{0x626f6f66});
    words.add(uint16_t{0x7261});
    EXPECT_EQ(bytes.value(), 0x85944171f73967e8u);
    EXPECT_EQ(words.value(), 0x85944171f73967e8u);
}

}  // namespace knuckle::test
