// How hard the stops of a joint hold.
#include "sim/joint/limits/joint_limit_states.glsl"

BUFFER(Assembly, AssemblyState, assemblies);

/// The part of what its stops held that a joint remembers in the next substep. Stops give by a hundredth of what moves
/// all that hangs on them, and contacts may press the latter much harder; but where a light body carries a heavy one,
/// the rest of a blow would throw that back. @param carried the mass that hangs on the joint [kg].
float memoryOf(Joint joint, float carried)
{
    const float LIGHT = 10.0;
    float lighter = moverMass(joint.body);
    if (responds(joint.parent)) lighter = min(lighter, moverMass(joint.parent));
    return carried > LIGHT * lighter ? 0.0 : 1.0;
}

/// The resistance to turns that a joint's stops add: for a rigid one, much more than that of the body with all that
/// hangs on it. @param inertia of that, seen from the joint.
mat3 limitStiffness(uint k, Inertia inertia)
{
    const float RIGID = 100.0;
    JointRange limits = fetchJointLimits(k);
    if (!isLimited(limits)) return mat3(0);
    Joint joint = fetchJoint(k);
    Assembly assembly = assemblies[fetchMover(joint.body).assembly];
    float factor = accelerationFactor(assembly);
    newJointLimitStates[JOINT_LIMIT_TEXELS * k + LIMIT_TORQUE].w = memoryOf(joint, meanMass(inertia.a));
    mat3 resistance = mat3(0);
    for (uint i = 0u; i < 2u; ++i) {
        uint stop = JOINT_LIMIT_TEXELS * k + LIMIT_AXES + i;
        vec4 axis = newJointLimitStates[stop];   // w: hardness
        if (axis.w == 0.0) continue;
        axis.w = limits.stiffness > 0.0 ? limits.stiffness * factor * sim.substepTime * sim.substepTime
                                        : RIGID * dot(axis.xyz, inertia.d * axis.xyz);
        newJointLimitStates[stop].w = axis.w;
        resistance += outerProduct(axis.w * axis.xyz, axis.xyz);
    }
    return resistance;
}
