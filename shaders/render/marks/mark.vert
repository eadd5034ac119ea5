// A corner of a mark at its body's place; strokes have the same width at any depth.
#include "render/common/frame_blocks.glsl"
#include "math/quaternion.glsl"

uniform samplerBuffer markCorners;          // MARK_TEXELS a corner
uniform samplerBuffer bodyCentres;
uniform samplerBuffer bodyRotations;

flat out vec3 color;

// Height over width of the picture.
float ratio()
{
    return float(frame.height) / float(frame.width);
}

vec4 placeOf(vec3 arm, float owner)
{
    if (owner == MARK_ON_PICTURE) return vec4(2.0 * arm.x * ratio() - 1.0, 1.0 - 2.0 * arm.y, 0.0, 1.0);
    int body = int(owner);
    return projectView(toView(texelFetch(bodyCentres, body).xyz + rotate(texelFetch(bodyRotations, body), arm)));
}

void main()
{
    int first = MARK_TEXELS * gl_VertexID;
    vec4 near = texelFetch(markCorners, first), far = texelFetch(markCorners, first + 1);
    vec2 shift = texelFetch(markCorners, first + 2).xy;
    vec4 here = placeOf(near.xyz, near.w), other = placeOf(far.xyz, near.w);
    vec2 way = (other.xy / other.w - here.xy / here.w) / vec2(ratio(), 1.0);
    vec2 along = length(way) > 1e-5 ? normalize(way) : vec2(1.0, 0.0);
    here.xy += 2.0 * (shift.x * along + shift.y * vec2(-along.y, along.x)) * vec2(ratio(), 1.0) * here.w;
    color = texelFetch(markCorners, first + 3).rgb;
    gl_Position = here;
}
