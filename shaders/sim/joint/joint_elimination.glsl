// What of a body, with all that hangs on it, is seen through its joint.
#include "sim/joint/joint_factors.glsl"
#include "sim/joint/joint_info.glsl"

/// What a joint passes on of all that it holds, seen from there. @param stops what its limits add to d.
Inertia handedOnBy(inout JointFactor f, uint freedom, mat3 stops)
{
    Inertia m = f.inertia;
    Inertia passed = m;
    mat3 d = m.d + stops;
    if (freedom == JOINT_BALL) {
        f.free = choleskyOf(d);
        // Where no limit holds, nothing of turns: not even rounding, which light bodies would take for an inertia.
        passed = Inertia(withoutTurns(m, f.free), stops * solve(f.free, m.b), stops - stops * solve(f.free, stops));
    }
    if (freedom == JOINT_HINGE) {
        float free = 1.0 / dot(f.axis, d * f.axis);
        f.free.inversePivots.x = free;
        vec3 b = f.axis * m.b, turning = m.d * f.axis;
        passed = Inertia(m.a - outerProduct(free * b, b), m.b - outerProduct(free * turning, b),
                         m.d - outerProduct(free * turning, turning));
    }
    return passed;
}
