// What a solid particle takes of fluids: a cube as wide as it, along the axes of its body. The cubes of a body fill it,
// so that its faces are as flat for fluids as walls are.
#include "math/quaternion.glsl"

struct SolidCell {
    vec3 centre;     // [m]
    vec3 move;       // its last [m]
    vec4 rotation;
};

const float TURN_STEPS = 2047.0;

/// A rotation in two floats, each a whole number below 2^24.
vec2 packTurn(vec4 q)
{
    ivec3 t = ivec3(round((q.w < 0.0 ? -q.xyz : q.xyz) * TURN_STEPS)) + 2048;
    return vec2(t.x * 4096 + t.y, t.z);
}

vec4 unpackTurn(vec2 t)
{
    int two = int(t.x);
    vec3 q = vec3(ivec3(two >> 12, two & 4095, int(t.y)) - 2048) / TURN_STEPS;
    return vec4(q, sqrt(max(1.0 - dot(q, q), 0.0)));
}

SolidCell fetchSolidCell(uint slot)
{
    vec4 now = texelFetch(slotPositions, int(slot)), move = texelFetch(slotMoves, int(slot));
    return SolidCell(now.xyz, move.xyz, unpackTurn(vec2(now.w, -move.w)));
}

/// Along one axis: the fraction of the kernel that lies between -d / 2 and d / 2 from t, its change with t [1/m], and
/// what its faces add to M.
vec3 betweenFaces(float t)
{
    vec2 sides = t + vec2(-0.5, 0.5) * sim.diameter;
    vec2 low = wallFraction(abs(sides.x)), high = wallFraction(abs(sides.y));
    float all = 2.0 * wallFraction(0.0).x;
    float before = sides.x < 0.0 ? low.x : all - low.x, upTo = sides.y < 0.0 ? high.x : all - high.x;
    return vec3(upTo - before, low.y - high.y, sides.y * high.y - sides.x * low.y) / all;
}

/// What a cell covers.
struct CellCover {
    vec3 slope;      // of the fraction [1/m]
    float fraction;  // of the kernel
    mat3 moment;     // what it adds to M of fluid_shape, besides the fraction
};

/// What a cell covers for a particle at an offset from it. The kernel is taken as the product of what it is along the
/// axes, so that cells side by side cover what a wall covers.
CellCover cellCover(SolidCell cell, vec3 offset)
{
    mat3 axes = matrixFromQuaternion(cell.rotation);
    vec3 r = offset * axes;
    vec3 x = betweenFaces(r.x), y = betweenFaces(r.y), z = betweenFaces(r.z);
    // Lists of neighbours end before the kernel does, so what is covered fades out there.
    float u = clamp((sim.fluidListReach - length(offset)) / (0.1 * sim.diameter), 0.0, 1.0);
    float scale = FLUID_SOLID_COVER * u * u * (3.0 - 2.0 * u);
    vec3 sides = scale * vec3(y.x * z.x, x.x * z.x, x.x * y.x), slope = sides * vec3(x.y, y.y, z.y);
    vec3 moment = sides * vec3(x.z, y.z, z.z);
    mat3 moments = mat3(moment.x * axes[0], moment.y * axes[1], moment.z * axes[2]) * transpose(axes);
    return CellCover(axes * slope, scale * x.x * y.x * z.x, moments);
}
