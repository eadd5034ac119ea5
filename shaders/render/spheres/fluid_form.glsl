// SURFACE: the spheroid as which a fluid particle is drawn, for the fragments of its image.
#include "math/spheroid.glsl"
#include "render/common/frame_blocks.glsl"

#ifdef SURFACE
uniform usamplerBuffer fluidForms;
flat out vec3 formAxis;       // in view space
flat out vec2 formScales;     // y makes it a ball across its axis, x does the rest along it

/// @returns the longest of its half lengths, over the radius.
float giveForm(uint particle)
{
    Spheroid form = unpackSpheroid(texelFetch(fluidForms, int(particle)).x);
    formAxis = directionToView(form.axis);
    formScales = vec2(form.across / form.along - 1.0, 1.0 / form.across);
    return max(form.along, form.across);
}
#else
float giveForm(uint particle) { return 1.0; }
#endif
