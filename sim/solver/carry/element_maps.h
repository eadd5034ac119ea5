#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/solver/stages.h"
#include "sim/world/match/counterparts.h"

namespace knuckle {

/// What the elements of a buffer are.
enum class Per {
    Particle,
    Body,
    Mover,
    Field,  ///< A texel of a mover's linear field: four of a body, one of a loose particle.
    Row,    ///< Of the channel.
    Joint,  ///< Of the trees, then loops.
    TreeJoint,
    Held,  ///< An entry of bodyReleases.
    Animated,
    Puppet,
    JointDrive,
    Pin,
    Motor,
    GearedHinge,
    Cluster,
    Distance,  ///< A node of a strand.
    Assembly,
};

/// The stages of a world, and that world.
struct StagesOf {
    const World& world;
    Stages& stages;
};

/// For each kind of element: per element of the later stages the index of the same in the earlier ones, or NO_INDEX.
class ElementMaps {
public:
    ElementMaps(const StagesOf& before, const StagesOf& after, const Counterparts& same);

    const std::vector<uint32_t>& of(Per kind) const { return maps_[static_cast<size_t>(kind)]; }

private:
    std::vector<uint32_t>& make(Per kind, size_t count);
    void mapMovers(const StagesOf& before, const StagesOf& after);
    void mapAssemblies(const StagesOf& before, const StagesOf& after);
    void mapRows(const StagesOf& before, const StagesOf& after);
    void mapJoints(const Layout& before, const Layout& after);
    void mapAnimated(const StagesOf& before, const StagesOf& after);
    void mapMotors(const StagesOf& before, const StagesOf& after);
    void mapGears(const StagesOf& before, const StagesOf& after);
    void mapDrives(const StagesOf& before, const StagesOf& after);
    void mapLoose(const StagesOf& before, const StagesOf& after, const Counterparts& same);

    std::array<std::vector<uint32_t>, static_cast<size_t>(Per::Assembly) + 1> maps_;
};

}  // namespace knuckle
