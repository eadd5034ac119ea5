// How near a particle comes to what it touches. Grains have sizes of their own (World: Particle::scale): moverCentres
// and searchPositions have the excess of their radius in w. The search looks as far as the largest need.

/// @param excess over half a diameter [m]. @returns from a particle's centre to its surface [m].
float particleRadius(float excess)
{
    return 0.5 * sim.diameter + excess;
}

/// Two particles of those radii are candidates of each other if nearer than this [m]. Grains touch no flat faces.
float pairReach(vec2 excess)
{
    bool grains = excess.x != 0.0 && excess.y != 0.0;
    return (grains ? sim.diameter + sim.drift : sim.plainReach) + (excess.x + excess.y);
}

/// A collider is a candidate of a particle whose centre is nearer than this to it [m].
float colliderReach(float excess)
{
    return sim.plainReach - 0.5 * sim.diameter + excess;
}
