#include "app/scene/scene_forces.h"

#include <fmt/format.h>

#include "app/json/fields.h"
#include "app/scene/scene_places.h"

namespace knuckle {

namespace {

void addField(const SceneEntry& entry)
{
    ForceField field = readFields<ForceField>(entry.json);
    field.region = readRegion(entry.json);
    field.stop = readUnlessZero(entry.json["stop"]);
    if (field.stop <= field.start)
        entry.fail("/stop", fmt::format("{:g} s is not after start, {:g} s; raise it or lower the other", field.stop,
                                        field.start));
    entry.context.builder.addForceField(field);
}

}  // namespace

void addForces(SceneContext& context, const Json& root)
{
    if (root.contains("wind")) context.builder.setWind(readFields<Wind>(root["wind"]));
    for (size_t i = 0; i < root["fields"].size(); ++i)
        addField({context, root["fields"][i], fmt::format("/fields/{}", i)});
}

}  // namespace knuckle
