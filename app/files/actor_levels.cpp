#include "app/files/actor_levels.h"

#include <fmt/format.h>

#include "app/files/actor_check.h"
#include "sim/base/errors.h"
#include "sim/rig/bodies/make_actor.h"
#include "sim/rig/skin/body_plan.h"

namespace knuckle {

std::vector<Actor> actorsOfLevels(const std::string& path, const Figure& figure, std::span<const uint32_t> levels,
                                  ActorOptions options)
{
    std::vector<Actor> actors;
    for (const uint32_t particles : levels) {
        options.particleCount = particles;
        if (!actors.empty()) options.plan = planOf(actors.front(), figure.model);
        actors.push_back(makeActor(figure, options));
        requireUsable(path, actors.back());
        if (const std::string difference = differenceOf(actors.front(), actors.back()); !difference.empty())
            throw InputError(fmt::format("{}: at {} particles the bodies are others than at {}: {}; leave one of these "
                                         "levels out",
                                         path, particles, levels.front(), difference));
    }
    return actors;
}

}  // namespace knuckle
