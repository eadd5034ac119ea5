#pragma once

namespace knuckle {

/// @throws std::logic_error unless it holds.
void requireJson(bool holds, const char* condition);

}  // namespace knuckle

// The library asserts that a constant object has the field that [] asks for. Release builds leave asserts out.
#define JSON_ASSERT(condition) ::knuckle::requireJson(condition, #condition)

#include <nlohmann/json.hpp>
