#pragma once

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "sim/solver/stages_state.h"

namespace knuckle {

/// Values of a buffer. @throws std::out_of_range if the state has none of that name.
template <typename T>
std::vector<T> readState(const StagesState& state, const std::string& name)
{
    const std::vector<std::byte>& bytes = state.buffers.at(name);
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

/// Replaces the first values of a buffer.
template <typename T>
void writeState(StagesState& state, const std::string& name, const std::vector<T>& values)
{
    std::vector<std::byte>& bytes = state.buffers.at(name);
    if (!values.empty()) std::memcpy(bytes.data(), values.data(), std::min(bytes.size(), values.size() * sizeof(T)));
}

}  // namespace knuckle
