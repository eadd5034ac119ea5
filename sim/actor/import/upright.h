#pragma once

#include "sim/actor/model.h"

namespace knuckle {

/// Turns a skeleton whose file does not say which axis points up so that its head is over its feet, where that is
/// another axis than y: at rest and in clips alike. A figure that lies in its clips, and stands at rest, lies. Told in
/// a note.
void standUpright(Model& model);

}  // namespace knuckle
