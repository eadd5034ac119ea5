// What kernels of shown quantities read and write.
#include "render/common/frame.glsl"

layout(local_size_x = RENDER_GROUP_SIZE) in;
layout(std430) writeonly buffer ShownQuantities { float shownQuantities[]; };
