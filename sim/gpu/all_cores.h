#pragma once

#include <cstddef>
#include <functional>

#include "sim/gpu/gpu.h"

namespace knuckle {

/// Makes GL objects on all cores: calls make(i, gpu) for each i below `count`, in any order and on several threads,
/// each with a context that shares objects with `gpu`'s. The calling thread, which has that context, works too. Where
/// no second context or thread can be had, or the address space is limited, it works alone.
/// @param make must not change what another call reads. @throws what it throws for the smallest i.
void makeOnAllCores(const Gpu& gpu, size_t count, const std::function<void(size_t, const Gpu&)>& make);

}  // namespace knuckle
