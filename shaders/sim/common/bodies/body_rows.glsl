// The channel through which constraints act on bodies. Each kind of constraint has reserved rows (sim/solver/layout/
// row_plan.h), one for each of its impulses on a body, and stores them in every iteration; the sum over them does not
// depend on kinds. ANGULAR: of a world where rows have angular impulses, too.
#include "sim/common/bodies/fields.glsl"
#include "sim/common/bodies/mover_poses.glsl"

uniform usamplerBuffer bodyRows;         // first row, how many
uniform samplerBuffer rowArms;
uniform samplerBuffer rowImpulses;
#ifdef ANGULAR
uniform samplerBuffer rowAngularImpulses;   // about the body's centre, in the axes of the world [kg m2]
#endif

/// What constraints add to a body. @param rotation its own now.
Field rowSum(uint body, vec4 rotation)
{
    Field sum = Field(vec3(0), mat3(0));
#ifdef ANGULAR
    vec3 angular = vec3(0);
#endif
    uvec2 rows = texelFetch(bodyRows, int(body)).xy;
    for (uint row = rows.x; row < rows.x + rows.y; ++row) {
        vec3 p = texelFetch(rowImpulses, int(row)).xyz;
        sum.t += p;
        sum.f += outerProduct(p, texelFetch(rowArms, int(row)).xyz);
#ifdef ANGULAR
        angular += texelFetch(rowAngularImpulses, int(row)).xyz;
#endif
    }
#ifdef ANGULAR
    // The antisymmetric half of p r^T turns a body; an angular impulse consists of this half only.
    mat3 axes = matrixFromQuaternion(rotation);
    angular *= 0.5;
    sum.f += mat3(cross(angular, axes[0]), cross(angular, axes[1]), cross(angular, axes[2]));
#endif
    return sum;
}
