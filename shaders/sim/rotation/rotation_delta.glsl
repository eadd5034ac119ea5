// The rotation of a body matched to its particles, by one of three methods:
//   vec4 matchedRotationDelta(mat3 a, vec4 start, vec4 delta)
// is the rotation from `start` to the orthogonal part of A (eq. 9); the search may begin at `delta`.
#include "math/quaternion.glsl"
#include "sim/rotation/newton_step.glsl"
#ifdef HOUSEHOLDER
#include "sim/rotation/householder.glsl"
#elif defined(HIGHAM)
#include "sim/rotation/higham.glsl"
#else
#include "sim/rotation/newton.glsl"
#endif
