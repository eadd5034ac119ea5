// Where rays that the surface has bent meet what is behind it.
#include "render/common/rays/mirrored.glsl"
#include "render/common/rays/picture_ray.glsl"

uniform sampler2D fluidGlowPicture;

const float STEP_PIXELS = 9.0;
const int MOST_STEPS = 12, NARROWINGS = 6;
const int ASIDE = 8;
const float MOST_LONGER = 3.0;
const float EDGE = 0.01;   // how far behind it is an edge, more than what there is from pixel to pixel [depths]

/// Where a bent ray ends, as a texture coordinate, and how much longer its way through fluid is than the straight one.
struct BentRay {
    vec2 place;
    float longer;
};

/// Where the line through two points of a ray has no gap.
float secant(vec2 one, vec2 other)
{
    return one.x + (other.x - one.x) * one.y / max(one.y - other.y, 1e-9);
}

/// Narrows down where a ray comes to lie behind what the picture shows: at a plane by secants, from either side as they
/// go a little too far, at the edge of a thing by halves.
void narrow(PictureRay ray, inout vec2 near, inout vec2 far)
{
    for (int k = 0; k < NARROWINGS; ++k) {
        float root = min(secant(near, far) + 0.1 * (far.x - near.x), far.x);
        vec2 there = pointOf(ray, k % 2 == 0 ? root : 0.5 * (near.x + far.x));
        if (there.y > 0.0) near = there;
        else far = there;
    }
}

/// Where something hidden would be seen if it went on to the side, as the ground does behind a thing.
vec2 seenBeside(vec3 hidden, vec3 way)
{
    vec3 side = normalize(cross(way, hidden)) * hidden.z / (float(frame.height) * 0.5 / frame.tanHalfFov);
    float pixels = 4.0;
    for (int k = 0; k < 2 * ASIDE; ++k) {
        vec3 there = hidden + pixels * side;
        if (behind(there) < EDGE * -hidden.z) return pictureOf(there + 2.0 * side);   // not the edge itself
        side = -side;
        if (k % 2 == 1) pixels *= 1.5;
    }
    return pictureOf(hidden);
}

/// How much fluid the straight ray through a point meets, at most [m].
float fluidAlong(vec3 p)
{
    return 1.3 * textureLod(fluidGlowPicture, pictureOf(p), 0.0).a + frame.fluidRadius;
}

/// Follows a bent ray through the depth picture, no further than the fluid reaches. What it passes behind at an edge is
/// met as if it were as thick as it is wide: at an angle `a` to the straight ray one comes to see (1 - cos a) / 2 of a
/// ball's width of its back. @param fluid  As much as the straight ray meets [m].
BentRay seenThrough(vec3 p, vec3 way, ivec2 pixel, float fluid)
{
    PictureRay ray = PictureRay(windowOf(p), windowOf(way));
    vec2 first = vec2(0.0, texelFetch(depthPicture, pixel, 0).r * frame.farDepth + p.z), before = first;
    float inside = 1.3 * fluid + frame.fluidRadius, air = max(first.y * length(p) / -p.z - inside, 0.0);
    // If the straight ray is in fluid all along, else no way is longer than another.
    float unbent = min(fluid + air, inside);
    if (air == 0.0) inside = max(inside, min(MOST_LONGER * inside, fluidAlong(p + MOST_LONGER * inside * way)));
    vec3 end = ray.start + inside * ray.way;
    float pixels = length(end.xy / end.z - gl_FragCoord.xy);
    int steps = clamp(int(pixels / STEP_PIXELS) + 2, 2, MOST_STEPS);
    float back = 0.5 * (1.0 - dot(way, normalize(p))), far = inside;
    vec2 seen = first, edge = first;   // the last point before an edge, and the first behind it
    bool hidden = false;
    for (int k = 1; k <= steps; ++k) {
        vec2 here = pointOf(ray, inside * float(k) / float(steps));
        bool comesOut = before.y <= 0.0 && here.y > 0.0;
        if (before.y > 0.0 && here.y <= 0.0) {
            seen = before, edge = here;
            narrow(ray, seen, edge);
            hidden = -edge.y > EDGE * -p.z;
            far = secant(seen, edge);
            if (!hidden) break;
        } else if (comesOut && -edge.y < back * (here.x - edge.x)) {
            hidden = false, far = edge.x;
            break;
        } else if (comesOut) hidden = false, far = inside;
        before = here;
    }
    if (hidden) far = first.y > seen.y ? clamp(secant(first, seen), seen.x, inside) : seen.x;
    vec2 place = pictureOf(p + far * way);
    if (hidden) place = seenBeside(p + far * way, way);
    return BentRay(place, min(far / max(unbent, 0.1 * frame.fluidRadius), MOST_LONGER));
}
