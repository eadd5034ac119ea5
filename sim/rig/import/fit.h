#pragma once

#include "sim/rig/model.h"
#include "sim/rig/model_source.h"

namespace knuckle {

/// Converts a model to metres, +Y up, and places it as the fit says. `notes` gets a sentence for each guess, and for a
/// figure of an odd size.
/// @throws InputError for a model without a size, or one that would become too small or too large.
void fitModel(Model& model, const ModelFit& fit);

}  // namespace knuckle
