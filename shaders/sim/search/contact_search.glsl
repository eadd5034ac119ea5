// Data of particles for the contact search, and storage for what it finds.
#include "math/quaternion.glsl"
#include "sim/common/contacts/touch.glsl"
#include "sim/common/contacts/round_bodies.glsl"
#include "sim/search/candidate_notes.glsl"
#include "sim/search/self_contact.glsl"
#include "sim/search/sorted_particles.glsl"
#include "sim/common/particles.glsl"

uniform samplerBuffer sortedPositions;
uniform usamplerBuffer sortedParticles;
uniform usamplerBuffer cellStarts;
uniform samplerBuffer searchRotations;
uniform samplerBuffer searchPositions;

SortedPosition fetchSortedPosition(uint k)
{
    return unpackSortedPosition(texelFetch(sortedPositions, int(k)));
}

SortedParticle fetchSortedParticle(uint k)
{
    return unpackSortedParticle(texelFetch(sortedParticles, int(k)).x);
}

/// Whether no other particle of a ball or capsule is nearer to a point than this one. The body is a cubic lattice, so
/// only the neighbours are checked. @param towards from the particle to the point, in the body's axes [m].
bool nearestOfRound(uint body, vec3 r, vec3 towards)
{
    RoundBody round = fetchRound(body);
    float inner = max(round.radius - 0.5 * sim.diameter, 0.0) + 2e-4 * sim.diameter;
    float own = dot(towards, towards) - 1e-4 * sim.diameter * sim.diameter;
    for (int k = 0; k < 27; ++k) {
        vec3 step = sim.diameter * (vec3(k % 3, k / 3 % 3, k / 9) - 1.0), place = r + step;
        vec3 left = towards - step, off = place - onLine(round, place);
        if (dot(left, left) < own && dot(off, off) <= inner * inner) return false;
    }
    return true;
}

/// Whether a pair that is less than sim.contactReach apart is near enough, and speaks for its bodies: of a ball or
/// capsule only the nearest particle does. @param difference from j to i [m].
bool speaks(uint i, uint j, vec3 difference, float further)
{
#if defined(ROUNDS) || defined(GRAINS)
    bool roundI = isRound(i), roundJ = isRound(j);
    vec2 excess = vec2(texelFetch(searchPositions, int(i)).w, texelFetch(searchPositions, int(j)).w);
    if (!roundI && !roundJ) return length(difference) < pairReach(excess) + further;
    if (fetchParticle(i).assembly == fetchParticle(j).assembly) return true;   // as particles
    uint a = fetchRank(i).mover, b = fetchRank(j).mover;
    vec3 inA = rotate(conjugate(texelFetch(searchRotations, int(a))), -difference);
    vec3 inB = rotate(conjugate(texelFetch(searchRotations, int(b))), difference);
    return (!roundI || nearestOfRound(a, fetchArm(i).r, inA)) && (!roundJ || nearestOfRound(b, fetchArm(j).r, inB));
#else
    return true;
#endif
}

/// Notes a pair. @param place the number of pairs that its first particle has found before.
void notePair(uint first, uint second, uint place)
{
    uint arrival = atomicAdd(listCounts[listIndex(LIST_AS_SECOND, fetchRank(second).rank)], 1u);
    note(Candidate(first, second, place, arrival));
}

void noteCount(uint first, uint count)
{
    listCounts[listIndex(LIST_AS_FIRST, fetchRank(first).rank)] = count;
}
