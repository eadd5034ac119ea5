#pragma once

#include <Eigen/Core>
#include <bit>
#include <string>

namespace knuckle {

static_assert(std::endian::native == std::endian::little, "binary files get values as they lie in memory");

/// Adds the bytes of a value, little-endian.
template <typename T>
void appendBytes(std::string& out, const T& value)
{
    out.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

inline void appendBytes(std::string& out, const Eigen::Vector3f& value)
{
    out.append(reinterpret_cast<const char*>(value.data()), 3 * sizeof(float));
}

}  // namespace knuckle
