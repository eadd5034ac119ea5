// How near a particle comes to what it touches. All particles have one size today; contacts ask here for those of the
// particles at hand, so that they could have several. The search looks as far as the largest need it.

/// From a particle's centre to its surface [m].
float particleRadius(uint i)
{
    return 0.5 * sim.diameter;
}

/// How far apart the centres of two particles are that just touch [m].
float touchDistance(uint i, uint j)
{
    return sim.diameter;
}

/// A collider is a candidate of a particle whose centre is nearer than this to it [m].
float colliderReach()
{
    return sim.plainReach - 0.5 * sim.diameter;
}
