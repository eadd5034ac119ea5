#include "app/scene/matter/soft_limits.h"

#include <fmt/format.h>

#include <map>

#include "sim/solver/layout/soft_pace.h"

namespace knuckle {

std::vector<std::string> softLimits(const World& world)
{
    if (world.settings.solver != SolverKind::Impulse) return {};
    std::map<uint32_t, SoftPace> least;  // by materials
    for (const SoftBody& soft : world.softBodies) {
        const SoftPace pace = softPace(world, soft);
        const auto [found, isNew] = least.try_emplace(soft.material, pace);
        if (!isNew && pace.stiffness < found->second.stiffness) found->second = pace;
    }
    std::vector<std::string> out;
    for (const auto& [index, pace] : least) {
        const Material& material = world.materials[index];
        const Elasticity& e = material.elasticity;
        std::string shown;
        if (pace.stiffness < 0.99f * e.stiffness)
            shown = fmt::format("a stiffness of {:.2g} Pa instead of {:.2g}", pace.stiffness, e.stiffness);
        if (pace.damping < 0.99f * e.damping)
            shown += fmt::format("{}a damping of {:.2g} s instead of {:.2g}", shown.empty() ? "" : " and ",
                                 pace.damping, e.damping);
        if (shown.empty()) continue;
        out.push_back(fmt::format("/materials/{}: soft bodies show {} at {} substeps and {} m; with more of "
                                  "/solver/substeps, or a larger /diameter, they show more",
                                  material.name, shown, world.settings.substeps, world.diameter()));
    }
    return out;
}

}  // namespace knuckle
