// How colliders move in the substep; at its end they are where colliderPlaces has them. MOVING: of a world in which any
// moves.
#include "sim/common/contacts/colliders.glsl"

#ifdef MOVING
uniform samplerBuffer colliderMoves;     // two a collider: shift [m], w: of its farthest point; turn

struct ColliderMove {
    vec3 shift;          // of its place [m]
    vec4 turn;           // about it
    float farthest;      // an upper bound of how far its points have moved [m]
};

ColliderMove fetchColliderMove(uint index)
{
    vec4 shift = texelFetch(colliderMoves, int(2u * index));
    return ColliderMove(shift.xyz, texelFetch(colliderMoves, int(2u * index) + 1), shift.w);
}
#endif

/// How far the collider's point that is now at x has moved [m].
vec3 surfaceMove(uint index, vec3 x)
{
#ifdef MOVING
    ColliderMove move = fetchColliderMove(index);
    vec3 arm = x - fetchColliderPlace(index).position;
    return move.shift + (arm - rotate(conjugate(move.turn), arm));
#else
    return vec3(0);
#endif
}

/// Where a point that was at x would be now if the collider had taken it along [m].
vec3 takenAlong(uint index, vec3 x)
{
#ifdef MOVING
    ColliderMove move = fetchColliderMove(index);
    vec3 place = fetchColliderPlace(index).position;
    return place + rotate(move.turn, x - (place - move.shift));
#else
    return x;
#endif
}
