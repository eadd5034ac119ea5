#pragma once

#include "sim/base/errors.h"

namespace knuckle {

/// A file has several skeletons and nobody said which, or none of the name that was given.
struct SkeletonError : InputError {
    using InputError::InputError;
};

}  // namespace knuckle
