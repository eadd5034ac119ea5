// Contacts as the search finds them, in any order, before pair_list gives them their places.

/// An entry of firstLists: the second particle of a pair, and how many pairs have found it before.
struct Candidate {
    uint second, arrival;
};

Candidate unpackCandidate(uvec2 t)
{
    return Candidate(t.x, t.y);
}

uvec2 packCandidate(Candidate candidate)
{
    return uvec2(candidate.second, candidate.arrival);
}

/// Where firstLists and colliderLists have entry k of a particle.
uint candidateIndex(uint k, uint particle)
{
    return k * sim.particleCount + particle;
}
