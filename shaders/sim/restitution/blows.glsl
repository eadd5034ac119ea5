// What a collision's blow leaves in buffers of restitution where it is passed on within a substep.

// pairRestitutions[].w of a contact whose impulse is taken back.
#define TAKEN_BACK (-2.0)
// moverRestitutionSplits[] of a mover that a blow has reached, but that does not collide itself.
#define REACHED (-1.0)
