// How near a particle comes to what it touches. All particles have one size today; contacts ask here for the size of
// each particle, so that there could be several. The search looks as far as the largest need.

/// From a particle's centre to its surface [m].
float particleRadius(uint i)
{
    return 0.5 * sim.diameter;
}

/// The distance of the centres of two particles that just touch [m].
float touchDistance(uint i, uint j)
{
    return sim.diameter;
}

/// A collider is a candidate of a particle whose centre is nearer than this to it [m].
float colliderReach()
{
    return sim.plainReach - 0.5 * sim.diameter;
}
