// What joints bear before they tear.
uniform usamplerBuffer jointStrengths;

struct JointStrength {
    float force, torque;   // [N, N m]
    uint first, end;       // of jointParticles
};

JointStrength fetchJointStrength(uint joint)
{
    uvec4 t = texelFetch(jointStrengths, int(joint));
    return JointStrength(uintBitsToFloat(t.x), uintBitsToFloat(t.y), t.z, t.w);
}
