// What is drawn over the lit picture in two parts, on either side of the fluids' surface: BEHIND_FLUIDS before they are
// drawn, BEFORE_FLUIDS after it, with them in the picture. Without either there are no fluids.
#include "render/common/frame_blocks.glsl"

uniform sampler2D depthPicture;

#if defined(BEHIND_FLUIDS) || defined(BEFORE_FLUIDS)
uniform sampler2D fluidWidePicture;

/// Depth of the fluids' surface at a place of the picture [m]; far if there is none.
float fluidAt(vec2 place)
{
    return textureLod(fluidWidePicture, place, 0.0).r;
}
#endif

/// Depth of what is in the picture at a place of it [m].
float depthAt(vec2 place)
{
    float depth = textureLod(depthPicture, place, 0.0).r * frame.farDepth;
#ifdef BEFORE_FLUIDS
    depth = min(depth, fluidAt(place));
#endif
    return depth;
}

/// Whether fluid is what is seen at a place of the picture.
bool showsFluid(vec2 place)
{
#ifdef BEFORE_FLUIDS
    return fluidAt(place) < textureLod(depthPicture, place, 0.0).r * frame.farDepth;
#else
    return false;
#endif
}

/// Whether what has this depth in this pixel [m] belongs to the other part.
bool isOtherSide(float depth)
{
#if defined(BEHIND_FLUIDS)
    return depth <= fluidAt(gl_FragCoord.xy / vec2(frame.width, frame.height));
#elif defined(BEFORE_FLUIDS)
    return depth > fluidAt(gl_FragCoord.xy / vec2(frame.width, frame.height));
#else
    return false;
#endif
}
