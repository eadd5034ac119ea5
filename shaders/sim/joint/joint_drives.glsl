// Stiffness that drives and pins add to the blocks of their joints (shaders/sim/drive).
#include "math/spatial.glsl"
#include "shared/drive_types.h"
#include "sim/joint/joint_info.glsl"

uniform samplerBuffer driveStiffness;

vec4 driveTexel(uint joint, uint texel)
{
    return texelFetch(driveStiffness, int(DRIVE_STIFFNESS_TEXELS * joint + texel));
}

/// Against turns about the joint [kg m2].
mat3 drivenStiffness(uint joint)
{
    return symmetricMatrix(driveTexel(joint, 0u).xyz, driveTexel(joint, 1u).xyz);
}

/// Against moves and turns of the joint's body.
Inertia pinStiffness(uint joint)
{
    vec4 t = driveTexel(joint, 2u);
    return Inertia(mat3(t.w), mat3(0), symmetricMatrix(t.xyz, driveTexel(joint, 3u).xyz));
}

/// Whether they differ from those that a tree was factored with.
bool drivesChanged(JointTree tree)
{
    for (uint k = tree.first; k < tree.end; ++k)
        if (driveTexel(k, 0u).w != 0.0 || driveTexel(k, 3u).w != 0.0) return true;
    return false;
}
