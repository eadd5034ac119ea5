// The inertia of a body, with all that hangs on it, that is seen through its joint.
#include "sim/joint/joint_factors.glsl"
#include "sim/joint/joint_info.glsl"

/// The inertia that a joint passes on, seen from there. @param stops what its limits add to d.
Inertia handedOnBy(inout JointFactor f, uint freedom, mat3 stops)
{
    Inertia m = f.inertia;
    Inertia passed = m;
    mat3 d = m.d + stops;
    if (freedom == JOINT_BALL) {
        f.free = choleskyOf(d);
        // Without a limit, passes on nothing for turns: not even rounding, which would be an inertia for light bodies.
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
