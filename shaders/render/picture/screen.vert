// One triangle over the whole picture.
#include "render/common/screen.glsl"

void main()
{
    gl_Position = screenCorner();
}
