#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "sim/gpu/buffer.h"

namespace knuckle {

/// A buffer of as many elements as there are values.
template <typename T>
Buffer<T> filledBuffer(std::string label, const std::vector<T>& values)
{
    return {std::move(label), std::span<const T>(values)};
}

}  // namespace knuckle
