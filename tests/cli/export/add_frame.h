#pragma once

#include <vector>

#include "app/export/exporter.h"

namespace knuckle::test {

/// Adds a frame to an exporter that needs only bodies.
inline void addFrame(Exporter& out, const World& world, const std::vector<BodyState>& bodies)
{
    out.frame({.world = world, .bodies = &bodies});
}

}  // namespace knuckle::test
