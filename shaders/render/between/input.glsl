// Which moment between two steps is meant.
#include "shared/frame_types.h"

layout(std140) uniform Between { BetweenInput between; };
