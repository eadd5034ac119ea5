// Which fluid particles a pass leaves out: SURFACE: those that are drawn as spheres; BEADS: those whose surface is
// drawn. FROM_OUTSIDE: all while the camera is in fluid.
#include "render/common/frame_blocks.glsl"
#include "render/common/submersion.glsl"

#if defined(SURFACE) || defined(BEADS)
uniform usamplerBuffer fluidMaterials;   // by fluid particle; NO_SURFACE

bool isLeftOut(uint particle)
{
    bool bead = texelFetch(fluidMaterials, int(particle - frame.solidCount)).x == NO_SURFACE;
#if defined(FROM_OUTSIDE)
    return bead || isUnderWater();
#elif defined(SURFACE)
    return bead;
#else
    return !bead;
#endif
}
#else
bool isLeftOut(uint particle) { return false; }
#endif

/// A place outside the picture for what is left out.
const vec4 NOWHERE = vec4(2.0, 2.0, 0.0, 1.0);
