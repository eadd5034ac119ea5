// Which bodies of an object never touch each other, as bits.
#include "sim/common/bodies/body_filters.glsl"

READ_BUFFER(uint, FilterBits, filterBits);
