// Loads on bodies that joints hold, beyond what their moves already answer, in the axes of the world. The last two
// texels are the hessian: xx, yy, zz, xy; xz, yz.
#include "shared/joint_records.h"
#include "sim/common/bodies/bodies.glsl"

uniform samplerBuffer bodyLoads;

struct BodyLoad {
    vec3 force;     // [kg m]
    vec3 torque;    // about the centre [kg m2]
    mat3 hessian;   // how hard it is to turn; the inertia, if nothing pulls the body apart [kg m2]
};

BodyLoad fetchBodyLoad(uint body)
{
    int first = int(BODY_LOAD_TEXELS * body);
    vec4 t = texelFetch(bodyLoads, first + 2);
    return BodyLoad(texelFetch(bodyLoads, first).xyz, texelFetch(bodyLoads, first + 1).xyz,
                    symmetricMatrix(t.xyz, vec3(t.w, texelFetch(bodyLoads, first + 3).xy)));
}

#define STORE_BODY_LOAD(loads, body, load) \
    loads[BODY_LOAD_TEXELS * (body)].xyz = (load).force; \
    loads[BODY_LOAD_TEXELS * (body) + 1u].xyz = (load).torque; \
    loads[BODY_LOAD_TEXELS * (body) + 2u] = vec4((load).hessian[0][0], (load).hessian[1][1], (load).hessian[2][2], \
                                   (load).hessian[0][1]); \
    loads[BODY_LOAD_TEXELS * (body) + 3u].xy = vec2((load).hessian[0][2], (load).hessian[1][2]);
