// Which bodies of an object never touch each other, as bits.
#include "sim/common/bodies/body_passes.glsl"

READ_BUFFER(uint, PassBits, passBits);
