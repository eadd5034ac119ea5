// The image of a sphere in a perspective camera.
#include "render/common/frame_blocks.glsl"

// Bounds of the sphere's image along one axis, as slopes x/depth: both tangents through the eye satisfy
// (a - s d)^2 = r^2 (1 + s^2). `a`: the centre along the axis, `d`: its view depth, > r.
vec2 sphereSlopes(float a, float d, float r)
{
    float root = r * sqrt(max(a * a + d * d - r * r, 0.0));
    return (a * d + vec2(-root, root)) / (d * d - r * r);
}

// Bounds in normalized device coordinates as (left, bottom, right, top). `scale`: NDC per slope.
vec4 sphereBounds(vec3 centreInView, float r, vec2 scale)
{
    float d = -centreInView.z;
    if (d <= r * 1.01) return vec4(-1.0, -1.0, 1.0, 1.0);
    vec2 x = sphereSlopes(centreInView.x, d, r) * scale.x;
    vec2 y = sphereSlopes(centreInView.y, d, r) * scale.y;
    return vec4(x.x, y.x, x.y, y.y) + pictureShift().xyxy;
}
