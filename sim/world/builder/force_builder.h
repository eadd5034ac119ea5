#pragma once

#include "sim/world/builder/world_draft.h"

namespace knuckle {

/// What acts from outside beside gravity.
class ForceBuilder : public virtual WorldDraft {
public:
    /// Air, which drags and moves.
    void setWind(const Wind& wind) { world_.wind = wind; }
    /// What blows needs air: still one, where setWind() has said nothing.
    void addForceField(const ForceField& field);
};

}  // namespace knuckle
