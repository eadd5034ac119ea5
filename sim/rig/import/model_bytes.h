#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/rig/model.h"

namespace knuckle {

/// The model as bytes for this machine's own pipes, not for files.
std::vector<uint8_t> toBytes(const Model& model);

/// The inverse. Trusts nothing: sizes, indices and finiteness are checked. @returns false for bytes that are not a
/// whole and valid model.
bool fromBytes(std::span<const uint8_t> bytes, Model& model);

}  // namespace knuckle
