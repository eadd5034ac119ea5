#pragma once

#include "tools/shapes/figure.h"
#include "tools/shapes/skeleton.h"

namespace knuckle {

/// Fur, eyes, nose and collar over the skeleton of makeDog().
Figure dogFigure(const Skeleton& skeleton);

/// Four beats, legs one after another, at 0.8 m/s.
Clip dogWalk(const Skeleton& skeleton);
/// Two beats, diagonal legs together, at 1.5 m/s.
Clip dogTrot(const Skeleton& skeleton);

}  // namespace knuckle
