#include "sim/world/joint/gear.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "sim/base/errors.h"
#include "sim/world/world.h"

namespace knuckle {

namespace {

/// @returns what is wrong with a gear; empty if nothing is.
std::string faultOf(const World& world, const Gear& gear)
{
    if (!std::isfinite(gear.ratio) || gear.ratio == 0.0f) return "its ratio must be finite and not 0";
    if (gear.first == gear.second) return "couples a hinge with itself; name two";
    for (const uint32_t j : {gear.first, gear.second}) {
        if (j >= world.joints.size()) return "couples a joint that does not exist";
        const Joint& joint = world.joints[j];
        if (joint.type != JointType::Hinge || !joint.geared)
            return fmt::format("the joint \"{}\" does not turn about one axis; use a hinge", joint.name);
        if (neverResponds(world.bodies[joint.parent]) && neverResponds(world.bodies[joint.child]))
            return fmt::format("the joint \"{}\" cannot turn, since both its bodies are fixed; free one of them",
                               joint.name);
    }
    if (world.settings.solver == SolverKind::Paper)
        return "the paper's solver has no gears; take it away, or use solver method impulse";
    return {};
}

/// Adds to a train all hinges that further gears couple with those it has.
class TrainGrower {
public:
    explicit TrainGrower(const World& world) : world_(world) {}

    bool has(uint32_t joint) const { return places_.contains(joint); }

    GearTrain grow(uint32_t joint)
    {
        GearTrain train;
        places_[joint] = 0;
        train.hinges.push_back({joint, NO_INDEX, 1.0f});
        for (size_t next = 0; next < train.hinges.size(); ++next)
            for (const Gear& gear : world_.gears) {
                const GearTrain::Hinge hinge = train.hinges[next];
                if (gear.first == hinge.joint) couple(train, next, gear, gear.second, hinge.ratio * gear.ratio);
                if (gear.second == hinge.joint) couple(train, next, gear, gear.first, hinge.ratio / gear.ratio);
            }
        return train;
    }

private:
    void couple(GearTrain& train, size_t place, const Gear& gear, uint32_t joint, float ratio)
    {
        constexpr float SAME = 1e-4f;
        const auto [found, isNew] = places_.try_emplace(joint, train.hinges.size());
        if (isNew) {
            train.hinges.push_back({joint, static_cast<uint32_t>(place), ratio});
            return;
        }
        const float other = train.hinges[found->second].ratio;
        if (std::abs(other - ratio) > SAME * std::abs(ratio))
            throw InputError(
                fmt::format("the gear \"{}\" closes a ring that cannot turn: by it \"{}\" has the ratio {:g}, "
                            "by the others {:g}; take it away, or change its ratio",
                            gear.name, world_.joints[joint].name, ratio, other));
    }

    const World& world_;
    std::map<uint32_t, size_t> places_;  // of each joint in its train
};

}  // namespace

std::vector<GearTrain> gearTrainsOf(const World& world)
{
    TrainGrower grower(world);
    std::vector<GearTrain> trains;
    for (const Gear& gear : world.gears)
        if (!grower.has(gear.first)) trains.push_back(grower.grow(gear.first));
    return trains;
}

void validateGears(const World& world)
{
    for (const Gear& gear : world.gears)
        if (const std::string fault = faultOf(world, gear); !fault.empty())
            throw InputError(fmt::format("the gear \"{}\": {}", gear.name, fault));
    gearTrainsOf(world);
}

}  // namespace knuckle
