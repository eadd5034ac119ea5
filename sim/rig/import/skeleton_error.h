#pragma once

#include "sim/base/errors.h"

namespace knuckle {

/// A file has several skeletons and none is picked, or has none of the given name.
struct SkeletonError : InputError {
    using InputError::InputError;
};

}  // namespace knuckle
