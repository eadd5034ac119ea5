#include "sim/world/builder/force_builder.h"

namespace knuckle {

void ForceBuilder::addForceField(const ForceField& field)
{
    world_.forceFields.push_back(field);
    if (field.kind == FieldKind::Blow && !world_.wind) world_.wind.emplace();
}

}  // namespace knuckle
