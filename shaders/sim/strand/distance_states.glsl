// What strand_solve stores of each link.
#include "sim/strand/precision.glsl"

/// Between iterations.
struct DistanceState {
    float multiplier;   // [kg m]
    float tension;      // of the last iteration [N]
    float torn;         // 1: it holds nothing any more
};

DistanceState distanceState(vec4 t)
{
    return DistanceState(t.x, t.y, t.z);
}

vec4 pack(DistanceState s)
{
    return vec4(s.multiplier, s.tension, s.torn, 0.0);
}

/// The same between the two sweeps of an iteration: the multiplier changes by the residual over the divisor.
struct EliminatedLink {
    float multiplier;
    float residual;     // [m]
    float torn;
    float divisor;      // [1/kg]; 0: it does nothing
};

EliminatedLink eliminatedLink(vec4 t)
{
    return EliminatedLink(t.x, t.y, t.z, t.w);
}

vec4 pack(EliminatedLink s)
{
    return vec4(s.multiplier, s.residual, s.torn, s.divisor);
}

/// Passed from the sweep that eliminates to the one that moves.
struct DistanceFactor {
    REAL3 n;           // unit, along the link
    REAL turning;      // resistance to turning it, k [kg]
    REAL3X3 inverse;   // B of its second node
    REAL3 r;           // impulse asked of that node [kg m]
};

#define STORE_DISTANCE_FACTOR(factors, k, factor) \
    factors[4u * k] = REAL4((factor).n, (factor).turning); \
    for (int line = 0; line < 3; ++line) \
        factors[4u * k + 1u + uint(line)] = REAL4((factor).inverse[line], (factor).r[line])

#define LOAD_DISTANCE_FACTOR(factors, k, factor) \
    (factor).n = factors[4u * k].xyz; \
    (factor).turning = factors[4u * k].w; \
    for (int line = 0; line < 3; ++line) { \
        REAL4 values = factors[4u * k + 1u + uint(line)]; \
        (factor).inverse[line] = values.xyz; \
        (factor).r[line] = values.w; \
    }

/// Resistance to the link's turning, k (1 - n n^T).
REAL3X3 turningMass(REAL3 n, REAL turning)
{
    return REAL3X3(turning) - turning * outerProduct(n, n);
}

/// What a move of a link's first node changes its residual by. Friction makes B asymmetric: n B k P is not k P B n.
REAL3 movedResidual(REAL3 n, REAL3X3 inverseB, REAL3X3 across)
{
#ifdef CONTACTS
    return n - (n * inverseB) * across;
#else
    return n - across * (inverseB * n);
#endif
}
