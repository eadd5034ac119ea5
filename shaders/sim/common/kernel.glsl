// What every kernel of the simulation starts with. The name of a block or a sampler is the name of the solver's buffer
// (docs/buffers.md); host code finds the binding by it.
#include "shared/counters.h"
#include "shared/step_parameters.h"

#define BUFFER(type, Block, name) layout(std430) restrict buffer Block { type name[]; }
#define READ_BUFFER(type, Block, name) layout(std430) restrict readonly buffer Block { type name[]; }
// The same as texels, whole ones: a software driver stores and reads those faster.
#define FLOAT_TEXELS(name) layout(rgba32f) restrict uniform imageBuffer name;
#define UINT_TEXELS(name) layout(rgba32ui) restrict uniform uimageBuffer name;

// llvmpipe reads a number of a uniform block for each thread, wherever it is used; one of a storage block only once for
// all, if that is before the first branch. Kernels that loop over neighbours are no faster by that, and those with
// eight storage blocks may have no more: they define UNIFORM_PARAMETERS.
#if defined(SOFTWARE_DRIVER) && !defined(UNIFORM_PARAMETERS)
READ_BUFFER(StepParameters, Step, stepParameters);
StepParameters sim = stepParameters[0];
#else
layout(std140) uniform Step { StepParameters sim; };
#endif

// An index of nothing: no pair, no cell, no second place.
#define NONE 0xffffffffu
