// One thread a tree of joints: of those that bore more in the substep than they can, the most loaded one tears, which
// relieves the others; and those whose time is over (LETS_GO: of a world that has any). A torn joint's body is then the
// root of what hangs on it, in the same tree; its particles stay with the first of their bodies.
#define UNIFORM_PARAMETERS
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/joint/joint_rows.glsl"
#include "sim/joint/joint_strength.glsl"

layout(local_size_x = TREE_GROUP_SIZE) in;
uniform usamplerBuffer jointParticles;
#ifdef LETS_GO
uniform usamplerBuffer jointReleases;     // the first substep without it
READ_BUFFER(Counters, CountersBlock, counters);
#endif
BUFFER(uint, JointFreedoms, newJointFreedoms);
BUFFER(vec4, JointLoads, jointLoads);
BUFFER(uvec2, ParticleLinks, newParticleLinks);
#ifdef FILTERS
#include "sim/common/bodies/body_filters.glsl"
uniform usamplerBuffer jointFilters;      // two bodies each, which collide again when it tears
BUFFER(uint, FilterBits, newFilterBits);

void forbid(uint body, uint other)
{
    uint bit = passBit(body, other);
    if (bit != NONE) atomicAnd(newFilterBits[bit >> 5], ~(1u << (bit & 31u)));
}
#endif

/// The mean of a joint's loads now and a substep ago: where second order begins, the load is first too low and then too
/// high.
vec3 meanLoad(uint entry, vec3 load)
{
    vec3 mean = 0.5 * (jointLoads[entry].xyz + load);
    jointLoads[entry].xyz = load;
    return mean;
}

/// A joint's load as a fraction of its strength, 0 if it is torn.
float loadOf(uint k, float squaredTime)
{
    Joint joint = fetchJoint(k);
    if (fetchFreedom(k) == JOINT_NONE || !responds(joint.body)) return 0.0;
    uint row = joint.row;
    JointStrength strength = fetchJointStrength(k);
    float load = length(meanLoad(JOINT_LOAD_TEXELS * k, newRowImpulses[row].xyz / squaredTime)) / strength.force;
#ifdef ANGULAR
    vec3 torque = meanLoad(JOINT_LOAD_TEXELS * k + 1u, newRowAngularImpulses[row].xyz / squaredTime);
    load = max(load, length(torque) / strength.torque);
#endif
    return load;
}

void tear(uint k)
{
    Joint joint = fetchJoint(k);
    JointStrength strength = fetchJointStrength(k);
    newJointFreedoms[k] = JOINT_NONE;
    clearRows(joint);
    for (uint i = strength.first; i < strength.end; ++i) newParticleLinks[texelFetch(jointParticles, int(i)).x].y = 1u;
#ifdef FILTERS
    uvec2 apart = texelFetch(jointFilters, int(k)).xy;
    forbid(apart.x, apart.y);
    forbid(apart.y, apart.x);
#endif
}

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= sim.jointTreeCount) return;
    JointTree tree = fetchJointTree(index);
    if (treeRests(tree)) return;
    uint assembly = fetchMover(fetchJoint(tree.first).body).assembly;
    float squaredTime = accelerationFactor(fetchAssembly(assembly)) * sim.substepTime * sim.substepTime;
    uint worst = NONE;
    float most = 1.0;
    uint joints = tree.end - tree.first, all = joints + tree.loopEnd - tree.firstLoop;
    for (uint i = 0u; i < all; ++i) {
        uint k = i < joints ? tree.first + i : tree.firstLoop + (i - joints);
#ifdef LETS_GO
        if (counters[0].substep >= texelFetch(jointReleases, int(k)).x && fetchFreedom(k) != JOINT_NONE) {
            tear(k);
            continue;
        }
#endif
        float load = loadOf(k, squaredTime);
        if (load > most) {
            most = load;
            worst = k;
        }
    }
    if (worst != NONE) tear(worst);
}
