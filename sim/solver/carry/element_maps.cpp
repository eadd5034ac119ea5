#include "sim/solver/carry/element_maps.h"

#include <map>
#include <tuple>
#include <utility>

namespace knuckle {

namespace {

uint32_t at(const std::vector<uint32_t>& map, uint32_t index)
{
    return index == NO_INDEX ? NO_INDEX : map[index];
}

/// Per animated body: its body.
std::vector<uint32_t> animatedBodies(const World& world)
{
    std::vector<uint32_t> bodies;
    for (const Animation& animation : world.animations)
        for (uint32_t b = objectOf(world, animation).bodyStart; b < objectOf(world, animation).bodyEnd(); ++b)
            bodies.push_back(b);
    return bodies;
}

/// Where texels of a mover's field begin.
uint32_t fieldStart(const Layout& layout, uint32_t mover)
{
    return mover < layout.bodyCount ? 4 * mover : 3 * layout.bodyCount + mover;
}

/// Per element of `after`, the index of the first in `before` that maps to the same.
std::vector<uint32_t> matched(const std::vector<uint32_t>& before, const std::vector<uint32_t>& after,
                              const std::vector<uint32_t>& map)
{
    std::map<uint32_t, uint32_t> indices;
    for (uint32_t i = 0; i < before.size(); ++i) indices.emplace(before[i], i);
    std::vector<uint32_t> out;
    for (const uint32_t element : after) {
        const auto found = indices.find(at(map, element));
        out.push_back(found == indices.end() ? NO_INDEX : found->second);
    }
    return out;
}

template <typename T>
std::vector<uint32_t> bodiesOf(const Buffer<T>& springs)
{
    std::vector<uint32_t> bodies;
    for (const T& spring : springs.download()) bodies.push_back(spring.body);
    return bodies;
}

template <typename T>
std::vector<uint32_t> jointsOf(const Buffer<T>& turned)
{
    std::vector<uint32_t> joints;
    for (const T& element : turned.download()) joints.push_back(element.joint);
    return joints;
}

}  // namespace

ElementMaps::ElementMaps(const StagesOf& before, const StagesOf& after, const Counterparts& same)
{
    make(Per::Particle, 0) = same.particles;
    make(Per::Body, 0) = same.bodies;
    mapMovers(before, after);
    mapAssemblies(before, after);
    mapRows(before, after);
    mapJoints(before.stages.layout, after.stages.layout);
    mapAnimated(before, after);
    mapDrives(before, after);
    mapMotors(before, after);
    mapGears(before, after);
    mapLoose(before, after, same);
}

std::vector<uint32_t>& ElementMaps::make(Per kind, size_t count)
{
    std::vector<uint32_t>& map = maps_[static_cast<size_t>(kind)];
    map.assign(count, NO_INDEX);
    return map;
}

void ElementMaps::mapMovers(const StagesOf& before, const StagesOf& after)
{
    const Layout &then = before.stages.layout, &now = after.stages.layout;
    std::vector<uint32_t>& movers = make(Per::Mover, now.moverCount());
    for (uint32_t b = 0; b < now.bodyCount; ++b) movers[b] = of(Per::Body)[b];
    for (uint32_t p = 0; p < now.solidCount; ++p) {
        const uint32_t mover = now.ranks[p].mover, earlier = of(Per::Particle)[p];
        if (mover < now.bodyCount || earlier == NO_INDEX) continue;
        const uint32_t was = then.ranks[earlier].mover;
        if (was >= then.bodyCount) movers[mover] = was;
    }
    std::vector<uint32_t>& fields = make(Per::Field, 3 * size_t{now.bodyCount} + now.moverCount());
    for (uint32_t m = 0; m < now.moverCount(); ++m) {
        if (movers[m] == NO_INDEX) continue;
        const uint32_t texels = m < now.bodyCount ? 4 : 1;
        for (uint32_t k = 0; k < texels; ++k) fields[fieldStart(now, m) + k] = fieldStart(then, movers[m]) + k;
    }
}

/// An assembly is the same if all of its particles are of one.
void ElementMaps::mapAssemblies(const StagesOf& before, const StagesOf& after)
{
    const Layout &then = before.stages.layout, &now = after.stages.layout;
    std::vector<uint32_t>& assemblies = make(Per::Assembly, now.assemblyCount);
    std::vector<bool> seen(now.assemblyCount);
    for (uint32_t p = 0; p < now.solidCount; ++p) {
        const uint32_t own = now.assemblies[p], was = at(then.assemblies, of(Per::Particle)[p]);
        assemblies[own] = !seen[own] || assemblies[own] == was ? was : NO_INDEX;
        seen[own] = true;
    }
}

void ElementMaps::mapRows(const StagesOf& before, const StagesOf& after)
{
    const RowPlan &then = before.stages.rows, &now = after.stages.rows;
    std::vector<uint32_t>& rows = make(Per::Row, now.arms().size());
    for (uint32_t b = 0; b < now.bodies().size(); ++b) {
        const uint32_t was = of(Per::Body)[b];
        if (was == NO_INDEX || then.bodies()[was].y != now.bodies()[b].y) continue;
        for (uint32_t k = 0; k < now.bodies()[b].y; ++k) rows[now.bodies()[b].x + k] = then.bodies()[was].x + k;
    }
}

void ElementMaps::mapJoints(const Layout& before, const Layout& after)
{
    using Key = std::tuple<bool, uint32_t, uint32_t>;  // whether it closes a loop, body, parent
    const auto keyOf = [](const JointTrees& trees, size_t k, uint32_t body, uint32_t parent) {
        return Key{k >= trees.joints.size(), body, parent};
    };
    const std::vector<JointTrees::Joint> then = before.jointTrees.all(), now = after.jointTrees.all();
    std::map<Key, uint32_t> keys;
    for (uint32_t k = 0; k < then.size(); ++k)
        keys.emplace(keyOf(before.jointTrees, k, then[k].body, then[k].parent), k);
    std::vector<uint32_t>& joints = make(Per::Joint, now.size());
    for (uint32_t k = 0; k < now.size(); ++k) {
        const uint32_t body = of(Per::Body)[now[k].body], parent = at(of(Per::Body), now[k].parent);
        const bool lost = body == NO_INDEX || (parent == NO_INDEX && now[k].parent != NO_INDEX);
        const auto found = keys.find(keyOf(after.jointTrees, k, body, parent));
        if (!lost && found != keys.end()) joints[k] = found->second;
    }
    const auto ofTrees = static_cast<std::ptrdiff_t>(after.jointTrees.joints.size());
    make(Per::TreeJoint, 0).assign(joints.begin(), joints.begin() + ofTrees);
}

void ElementMaps::mapAnimated(const StagesOf& before, const StagesOf& after)
{
    const std::vector<uint32_t>& bodies = of(Per::Body);
    make(Per::Animated, 0) = matched(animatedBodies(before.world), animatedBodies(after.world), bodies);
    make(Per::Held, 0) = matched(before.stages.layout.heldBodies, after.stages.layout.heldBodies, bodies);
}

void ElementMaps::mapDrives(const StagesOf& before, const StagesOf& after)
{
    if (!before.stages.drives || !after.stages.drives) return;
    const DriveStage &then = *before.stages.drives, &now = *after.stages.drives;
    const std::vector<uint32_t>& animated = of(Per::Animated);
    make(Per::JointDrive, 0) = matched(bodiesOf(then.jointDrives), bodiesOf(now.jointDrives), animated);
    make(Per::Pin, 0) = matched(bodiesOf(then.pins), bodiesOf(now.pins), animated);
    const auto firstBodies = [](const World& world) {
        std::vector<uint32_t> first;
        for (const Puppet& puppet : world.puppets) first.push_back(objectOf(world, puppet).bodyStart);
        return first;
    };
    make(Per::Puppet, 0) = matched(firstBodies(before.world), firstBodies(after.world), of(Per::Body));
}

void ElementMaps::mapMotors(const StagesOf& before, const StagesOf& after)
{
    if (!before.stages.motors || !after.stages.motors) return;
    make(Per::Motor, 0) = matched(jointsOf(before.stages.motors->motors), jointsOf(after.stages.motors->motors),
                                  of(Per::TreeJoint));
}

void ElementMaps::mapGears(const StagesOf& before, const StagesOf& after)
{
    if (!before.stages.gears || !after.stages.gears) return;
    make(Per::GearedHinge, 0) = matched(jointsOf(before.stages.gears->gearHinges),
                                        jointsOf(after.stages.gears->gearHinges), of(Per::TreeJoint));
}

void ElementMaps::mapLoose(const StagesOf& before, const StagesOf& after, const Counterparts& same)
{
    std::vector<uint32_t>& clusters = make(Per::Cluster, after.world.clusters.size());
    for (uint32_t s = 0; s < same.softBodies.size(); ++s) {
        if (same.softBodies[s] == NO_INDEX) continue;
        const SoftBody &then = before.world.softBodies[same.softBodies[s]], &now = after.world.softBodies[s];
        for (uint32_t k = 0; k < now.clusterCount; ++k) clusters[now.clusterStart + k] = then.clusterStart + k;
    }
    if (!before.stages.strands || !after.stages.strands) return;
    const StrandStage &then = *before.stages.strands, &now = *after.stages.strands;
    std::vector<uint32_t>& distances = make(Per::Distance, now.distanceStates.size());
    for (uint32_t s = 0; s < same.strands.size(); ++s)
        for (size_t k = 0; same.strands[s] != NO_INDEX && k < after.world.strands[s].restLengths.size(); ++k)
            distances[now.stateOf(after.world, s, k)] = static_cast<uint32_t>(
                then.stateOf(before.world, same.strands[s], k));
}

}  // namespace knuckle
