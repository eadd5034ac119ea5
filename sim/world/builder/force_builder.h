#pragma once

#include "sim/world/builder/world_draft.h"

namespace knuckle {

/// Accelerations from outside other than gravity.
class ForceBuilder : public virtual WorldDraft {
public:
    /// Sets the air, which drags and moves.
    void setWind(const Wind& wind) { world_.wind = wind; }
    /// A field that blows needs air: calm air without setWind().
    void addForceField(const ForceField& field);
};

}  // namespace knuckle
