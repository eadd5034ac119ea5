// The host's values of a frame.
#include "shared/draw_types.h"
#include "shared/frame_types.h"

layout(std140) uniform Frame { FrameInput frame; };
