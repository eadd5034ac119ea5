#include "app/scene/scene_limits.h"

#include <fmt/format.h>

#include "app/scene/scene_context.h"
#include "app/scene/scene_repeat.h"

namespace knuckle {

void limitTotal(const SceneEntry& entry, const char* field, double count, const char* remedy)
{
    const WorldBuilder& builder = entry.context.builder;
    const double total = count + builder.particleCount() + builder.fluidCount() + builder.world().pooledCount();
    if (total <= static_cast<double>(MAX_PARTICLES)) return;
    const std::string number = total < 1e15 ? fmt::format("{:.0f}", total) : fmt::format("{:.1e}", total);
    entry.fail(field,
               fmt::format("brings the scene to {} particles, the limit is {}; {}", number, MAX_PARTICLES, remedy));
}

void limitParticles(const SceneEntry& object, double count)
{
    limitTotal(object, "", count * static_cast<double>(copyCount(object.json)),
               "raise /diameter, or make it smaller or fewer");
}

}  // namespace knuckle
