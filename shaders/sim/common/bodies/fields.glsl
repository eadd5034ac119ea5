// Linear fields over a body: each particle has t + f r, r being its place in the body. Positions, moves, velocities and
// the sums of shape matching are such fields, so a rigid body is predicted, matched and finished without a visit to its
// particles. Loose particles have t only.

// A kernel may be for bodies or for loose particles alone.
#if defined(BODIES)
#define IS_BODY(mover) true
#elif defined(LOOSE)
#define IS_BODY(mover) false
#else
#define IS_BODY(mover) ((mover) < sim.bodyCount)
#endif

struct Field {
    vec3 t;
    mat3 f;
};

uint fieldStart(uint mover)
{
    return IS_BODY(mover) ? 4u * mover : 3u * sim.bodyCount + mover;
}

Field fetchField(samplerBuffer fields, uint mover)
{
    int start = int(fieldStart(mover));
    Field field = Field(texelFetch(fields, start).xyz, mat3(0));
    if (IS_BODY(mover))
        for (int column = 0; column < 3; ++column) field.f[column] = texelFetch(fields, start + 1 + column).xyz;
    return field;
}

/// The relaxation of a mover's contacts, stored beside the last change of its contact impulses (moverChanges).
float fetchRelaxation(samplerBuffer changes, uint mover)
{
    return texelFetch(changes, int(fieldStart(mover))).w;
}

/// Stores it, after the field. A macro like the next.
#define STORE_RELAXATION(changes, mover, relaxation) changes[fieldStart(mover)].w = relaxation;

/// An upper bound of the speed of a mover's particles with this velocity field; the farthest is `radius` away.
float fastestOf(Field v, float radius)
{
    return length(v.t) + radius * sqrt(dot(v.f[0], v.f[0]) + dot(v.f[1], v.f[1]) + dot(v.f[2], v.f[2]));
}

/// Stores into an array of fields; a macro, as GLSL passes no arrays of unknown size.
#define STORE_FIELD(fields, mover, field) \
    fields[fieldStart(mover)] = vec4((field).t, 0); \
    if (IS_BODY(mover)) { \
        fields[fieldStart(mover) + 1u] = vec4((field).f[0], 0); \
        fields[fieldStart(mover) + 2u] = vec4((field).f[1], 0); \
        fields[fieldStart(mover) + 3u] = vec4((field).f[2], 0); \
    }
