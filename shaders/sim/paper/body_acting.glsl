// How much of a body the pushed particles move.

/// Sums of the particles' fractions, in 1 / FRACTION_PARTS.
struct BodyActingSums {
    uint now;       // being counted in this iteration
    uint last;      // of the last one
};
