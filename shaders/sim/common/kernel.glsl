// What every kernel of the simulation starts with. The name of a block or a sampler is the name of the solver's buffer
// (docs/buffers.md); host code finds the binding by it.
#include "shared/counters.h"
#include "shared/step_parameters.h"

#define BUFFER(type, Block, name) layout(std430) restrict buffer Block { type name[]; }
#define READ_BUFFER(type, Block, name) layout(std430) restrict readonly buffer Block { type name[]; }
// The same as texels, whole ones: a software driver stores and reads those faster.
#define FLOAT_TEXELS(name) layout(rgba32f) restrict uniform imageBuffer name;
#define UINT_TEXELS(name) layout(rgba32ui) restrict uniform uimageBuffer name;

layout(std140) uniform Step { StepParameters sim; };

// An index of nothing: no pair, no cell, no second place.
#define NONE 0xffffffffu
