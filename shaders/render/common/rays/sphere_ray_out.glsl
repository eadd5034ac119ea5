// What vertices say of the frame to the fragments of a sphere, as llvmpipe reads uniforms once for every pixel.
#include "render/common/frame_blocks.glsl"

flat out vec4 rayLine;          // the slopes of a pixel's ray: xy by its window coordinate, and zw
flat out float perFarDepth;     // [1/m]

void giveRays()
{
    vec2 size = vec2(frame.width, frame.height), slope = frame.tanHalfFov * vec2(size.x / size.y, 1.0);
    rayLine = vec4(2.0 * slope / size, -(1.0 + pictureShift()) * slope);
    perFarDepth = 1.0 / frame.farDepth;
}
