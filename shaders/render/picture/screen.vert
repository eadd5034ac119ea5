// One triangle over the whole picture.
#include "render/common/flat/flat_frame_out.glsl"
#include "render/common/screen.glsl"

void main()
{
    gl_Position = screenCorner();
    giveFrame();
}
