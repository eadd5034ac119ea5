#pragma once

#include <stdexcept>
#include <string>

namespace knuckle {

/// @throws std::logic_error unless it holds.
inline void requireJson(bool holds, const char* condition)
{
    if (!holds) throw std::logic_error(std::string("JSON is read against its form: ") + condition);
}

}  // namespace knuckle

// The library asserts that a constant object has the field that [] asks for. Release builds leave asserts out.
#define JSON_ASSERT(condition) ::knuckle::requireJson(condition, #condition)

#include <nlohmann/json.hpp>
