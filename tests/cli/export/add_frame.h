#pragma once

#include <vector>

#include "app/export/exporter.h"

namespace knuckle::test {

/// To an exporter that needs bodies alone.
inline void addFrame(Exporter& out, const World& world, const std::vector<BodyState>& bodies)
{
    out.frame({.world = world, .bodies = &bodies});
}

}  // namespace knuckle::test
