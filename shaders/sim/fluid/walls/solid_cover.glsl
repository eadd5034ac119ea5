// The part of a fluid particle's smoothing kernel that solid particles cover.

/// The density that they add, and how that changes with its position.
struct SolidCover {
    vec3 slope;      // of the fraction [1/m]
    float fraction;  // of the kernel
    float weights;   // sum of solidWeight()
    vec3 move;       // mean of the solids', by their weights [m]
    float squares;   // sum of the squares of the slopes of each [1/m2]
};

/// The cover by the solid neighbours of slot k, for a particle at x. The slope is taken across the surface that they
/// form together: along it, their bumps would hold the fluid. In a gap or a hole they form no surface; there the slope
/// has to be that of the fraction, or a particle that came in slowly would be shot out.
SolidCover solidCover(uint k, uint count, vec3 x)
{
    SolidCover cover = SolidCover(vec3(0), 0.0, 0.0, vec3(0), 0.0);
    vec3 outward = vec3(0, 1e-12, 0);
    for (uint n = 0u; n < count; ++n) {
        uint slot = fetchSolidNeighbour(k, n);
        vec3 there = fetchSlotPosition(slot).position, offset = x - there;
        float r = length(offset), weight = solidWeight(r);
        vec2 covered = solidFraction(r, solidDiameter(fetchSlotParticle(slot)));
        cover.fraction += covered.x;
        cover.slope += covered.y * offset;
        cover.squares += covered.y * covered.y * r * r;
        cover.weights += weight;
        cover.move += weight * (there - fetchSlotLast(slot).position);
        outward += weight / max(r, 1e-9) * offset;
    }
    cover.move /= max(cover.weights, 1e-20);
    vec3 normal = normalize(outward), along = cover.slope - dot(cover.slope, normal) * normal;
    float oneSided = smoothstep(0.3, 0.6, length(outward) / max(cover.weights, 1e-20));
    cover.slope -= oneSided * along;
    return cover;
}

/// What solids add to M of fluid_shape: as fluid behind their surface, three quarters of a spacing away.
mat3 solidMoment(SolidCover cover)
{
    return 0.75 * sim.fluidSpacing / max(length(cover.slope), 1e-20) * outerProduct(cover.slope, cover.slope);
}
