#pragma once

#include "sim/rig/model.h"
#include "sim/rig/model_source.h"

namespace knuckle {

/// Brings a model into metres, +Y up, and where the fit wants it. `notes` gets a sentence for what was guessed, and
/// for a figure whose size is odd.
/// @throws InputError for a model without a size, or one that would be too small or too large.
void fitModel(Model& model, const ModelFit& fit);

}  // namespace knuckle
