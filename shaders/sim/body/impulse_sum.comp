// One thread a body: sums the impulses of its contacts and those on its particles. Also counts the contacts that will
// act next, over which its mass is split. WARM_START: the old impulses of new contacts.
#define BODIES
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/fields.glsl"
#include "sim/body/contact_response.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer bodyRows;         // of the channel: first row, how many
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, BodyPushes, bodyPushes);   // fields
#ifdef ON_PARTICLES
BUFFER(vec4, BodyParticlePushes, bodyParticlePushes);
#endif

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.bodyCount || !responds(m)) return;
    Mover mover = fetchMover(m);
    float others = 0.0;
#ifdef WARM_START
    // Before the first solve no joint has an impulse yet: each row counts as an impulse on the body.
    if (counters[0].substep == 1u) others = float(texelFetch(bodyRows, int(m)).y);
#endif
    ContactResponse contacts = contactResponse(m, mover, others);
    moverMoves[m].w = contacts.splits;
    Field particles = particleSum(mover);
#ifdef ON_PARTICLES
    STORE_FIELD(bodyParticlePushes, m, particles)
#endif
    Field push = Field(contacts.impulse.t + particles.t, contacts.impulse.f + particles.f);
    STORE_FIELD(bodyPushes, m, push)
}
