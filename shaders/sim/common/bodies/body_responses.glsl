// How bodies that joints connect answer to forces together: per body the motion of its centre for a force on it, with
// all that its joints move along. Zero for a body without joints.
#include "math/spatial.glsl"
#include "shared/joint_records.h"

uniform samplerBuffer bodyResponses;

mat3 fetchResponseBlock(uint body, uint block)
{
    int first = int(BODY_RESPONSE_TEXELS * body + 3u * block);
    return mat3(texelFetch(bodyResponses, first).xyz, texelFetch(bodyResponses, first + 1).xyz,
                texelFetch(bodyResponses, first + 2).xyz);
}

Response fetchBodyResponse(uint body)
{
    return Response(fetchResponseBlock(body, 0u), fetchResponseBlock(body, 1u), fetchResponseBlock(body, 2u));
}
