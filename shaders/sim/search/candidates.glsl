// Contacts as the search finds them, in any order, before pair_list gives them their places.

/// A pair of particles, or a particle and a collider.
struct Candidate {
    uint first;     // particle
    uint second;    // particle or collider
    uint place;     // number of contacts of its kind that its first particle had found before
    uint arrival;   // number of pairs that had found its second particle before; NONE: a contact with a collider
};

Candidate unpackCandidate(uvec4 t)
{
    return Candidate(t.x, t.y, t.z, t.w);
}

uvec4 packCandidate(Candidate candidate)
{
    return uvec4(candidate.first, candidate.second, candidate.place, candidate.arrival);
}
