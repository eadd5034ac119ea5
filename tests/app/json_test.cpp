#include "app/json/json.h"

#include <gtest/gtest.h>

namespace knuckle::test {

namespace {

/// In release builds, too: the library alone would go on with what lies behind the object.
TEST(Json, ThatLacksAFieldSaysSo)
{
    const Json object = parseJson(R"({ "radius": 1 })", "object");
    EXPECT_EQ(object["radius"], 1);
    EXPECT_THROW(object["length"].get<double>(), std::logic_error);
}

}  // namespace

}  // namespace knuckle::test
