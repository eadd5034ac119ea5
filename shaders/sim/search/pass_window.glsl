// Most of what is near a particle belongs to its mover or to one that its mover passes (Body::passes). A window tells
// these apart without a look at the particles.
#include "sim/search/sorted_particles.glsl"

/// 32 movers from `first` on, in names as of sortedMover(): those with a bit never touch a particle.
struct PassWindow {
    uint first, bits;
};

bool isIn(PassWindow window, uint name)
{
    uint k = name - window.first;
    return k < 32u && (window.bits >> (k & 31u) & 1u) != 0u;
}

#ifdef PASSES
#include "sim/search/pass_bits.glsl"

/// The mover itself and what it passes of the 32 bodies of its object that share a word of passBits with it.
PassWindow windowAround(uint name)
{
    uint mover = name - sortedMover(0u, false);
    BodyPasses passes = fetchBodyPasses(min(mover, sim.bodyCount - 1u));
    uint k = mover - passes.firstBody, word = k & ~31u;
    if (mover >= passes.endBody || mover < passes.firstBody) return PassWindow(name, 1u);
    return PassWindow(name - (k & 31u), passBits[(passes.firstBit + word) >> 5] | 1u << (k & 31u));
}
#else
PassWindow windowAround(uint name)
{
    return PassWindow(name, 1u);
}
#endif
