// One thread a body with joints: the load that the impulses on it leave, for the joints of its tree to answer all at
// once.
#define JOINTED
#include "sim/common/kernel.glsl"
#include "sim/body/mover_threads.glsl"
#include "sim/rotation/rotation_delta.glsl"
#include "sim/common/bodies/body_rows.glsl"
#include "sim/common/bodies/fields.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/body/body_load.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moverPredictions;
uniform samplerBuffer bodyPushes;
#ifdef ON_PARTICLES
uniform samplerBuffer bodyParticlePushes;
#endif
BUFFER(vec4, BodyLoads, newBodyLoads);

void main()
{
    if (gl_GlobalInvocationID.x >= THREAD_COUNT) return;
    uint m = moverOfThread(gl_GlobalInvocationID.x);
    if (!responds(m)) return;
    Field push = fetchField(bodyPushes, m), others = Field(vec3(0), mat3(0));
#ifdef ON_PARTICLES
    others = fetchField(bodyParticlePushes, m);
#endif
    vec4 rotation = fetchRotation(m), delta = fetchRotationDelta(m);
    Field rows = rowSum(m, quaternionProduct(delta, rotation));
    BodyLoad load = loadOf(fetchField(moverPredictions, m), Field(push.t + rows.t, push.f + rows.f), others.f + rows.f,
                           fetchMove(m).shift, rotation, delta, fetchMover(m).inverseMass, fetchMoments(m));
    STORE_BODY_LOAD(newBodyLoads, m, load)
}
