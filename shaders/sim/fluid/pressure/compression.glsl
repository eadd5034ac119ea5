// Sums over the fluid neighbours of a particle for its density and the compression by their moves.

struct Own {
    vec3 position, move;
    mat3 even;
};

/// What walls and solids add.
struct Sides {
    vec3 gradient;    // of what they cover [1/m]
    float fraction;   // of the kernel, which they cover
    float opposed;    // SolidCover
    float nearer;     // by how much moves make the fluid denser there
    float gain, fastest;   // SlotCover
};

/// Sums over fluid neighbours, in units of the kernel's height and steepness: the fraction of the kernel, its gradient,
/// the squares of each one's share of that, by how much their moves make the fluid denser, and the fraction of those
/// that are new.
struct Sums {
    vec3 gradient;
    float fraction, squares, nearer;
    float added;   // EMITTERS
};

void add(inout Sums sums, Own own, float inverseReach, uint slot)
{
    vec3 there = fetchSlotPosition(slot).position, r = own.position - there;
    float squared = dot(r, r), a = 1.0 - min(sqrt(squared) * inverseReach, 1.0), cube = a * a * a;
    SlotMove other = fetchSlotMove(slot);
    sums.fraction += fluidShape(a);
    sums.gradient += cube * r;
    sums.squares += cube * cube * squared;
    vec3 move = own.move - other.move;
#ifdef EMITTERS
    if (other.isNew) move = vec3(0), sums.added += fluidShape(a);
#endif
    sums.nearer += cube * dot(own.even * r, move);
}

Sums sumsOver(uint k, uint count, Own own)
{
    // What the list ends with is subtracted again.
    Sums sums = Sums(vec3(0), 1.0 - float(paddingOf(count)), 0.0, 0.0, 0.0);
    float inverseReach = 1.0 / sim.fluidReach, steepness = fluidSteepness();
    NeighbourTexels texels = neighbourTexels(k, count);
    do {
        uvec4 slots = texels.slots;
        add(sums, own, inverseReach, slots.x);
        add(sums, own, inverseReach, slots.y);
        add(sums, own, inverseReach, slots.z);
        add(sums, own, inverseReach, slots.w);
    } while (nextTexel(texels));
    return Sums(steepness * sums.gradient, sim.fluidVolume * sums.fraction, steepness * steepness * sums.squares,
                steepness * sums.nearer, sim.fluidVolume * sums.added);
}
