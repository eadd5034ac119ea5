// How much of a body the particles move that contacts push.

/// Sums of their fractions, in 1 / FRACTION_PARTS.
struct BodyActingSums {
    uint now;       // being counted in this iteration
    uint last;      // of the last one
};
