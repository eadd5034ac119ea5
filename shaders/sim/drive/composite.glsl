// Bodies taken as one that is rigid as it stands now.
#include "math/symmetric.glsl"

struct Composite {
    float mass;      // [kg]
    vec3 centre;     // [m]
    mat3 inertia;    // about the centre [kg m2]
};

/// The inertia of a mass at an arm, about the start of the arm.
mat3 atArm(float mass, vec3 arm)
{
    return mass * (mat3(dot(arm, arm)) - outerProduct(arm, arm));
}

/// @param sign 1 to add the second, -1 to take it out of the first.
Composite joined(Composite a, Composite b, float sign)
{
    float mass = a.mass + sign * b.mass;
    vec3 centre = (a.mass * a.centre + sign * b.mass * b.centre) / mass;
    return Composite(mass, centre, a.inertia + atArm(a.mass, a.centre - centre) +
                                       sign * (b.inertia + atArm(b.mass, b.centre - centre)));
}

#define STORE_COMPOSITE(composites, k, c) \
    composites[3u * (k)] = vec4((c).centre, (c).mass); \
    composites[3u * (k) + 1u].xyz = diagonalOf((c).inertia); \
    composites[3u * (k) + 2u].xyz = offDiagonalOf((c).inertia);

#define COMPOSITE_FROM(composites, k) \
    Composite(composites[3u * (k)].w, composites[3u * (k)].xyz, \
              symmetricMatrix(composites[3u * (k) + 1u].xyz, composites[3u * (k) + 2u].xyz))

/// How one side of a joint answers to forces and torques there.
struct Side {
    float inverseMass;
    mat3 inverseInertia;
    mat3 arm;            // the matrix of the cross product with that from the centre to the joint
};

Side sideOf(Composite c, vec3 anchor)
{
    vec3 v = anchor - c.centre;
    return Side(1.0 / c.mass, inverse(c.inertia), mat3(0, v.z, -v.y, -v.z, 0, v.x, v.y, -v.x, 0));
}

/// The inertia that resists a turn of one side against the other if only the joint holds the two: the force F at the
/// joint is A^-1 B of a torque between both.
mat3 turnedInertia(Side child, Side parent)
{
    mat3 a = mat3(child.inverseMass + parent.inverseMass) - child.arm * child.inverseInertia * child.arm -
             parent.arm * parent.inverseInertia * parent.arm;
    mat3 b = child.arm * child.inverseInertia + parent.arm * parent.inverseInertia;
    return inverse(child.inverseInertia + parent.inverseInertia - transpose(b) * inverse(a) * b);
}
