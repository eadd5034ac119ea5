#include "sim/world/builder/parts/clusters.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "sim/base/disjoint_sets.h"
#include "sim/world/builder/builder.h"
#include "sim/world/space/cells.h"

namespace knuckle {

namespace {

using Members = std::vector<uint32_t>;
using Cell = Cells::Cell;

constexpr float NEIGHBOUR_DISTANCE = 1.8f;  // diameters: lattice neighbours by a face, an edge or a corner
constexpr float LATTICE_SLACK = 0.25f;      // diameters: how far off its layer a particle may be and still belong to it

bool areNeighbours(const Vector3f& a, const Vector3f& b, float diameter)
{
    return (a - b).squaredNorm() < NEIGHBOUR_DISTANCE * NEIGHBOUR_DISTANCE * diameter * diameter;
}

/// The particles in each box, boxes in the order of their places.
std::map<Cell, Members> fillBoxes(std::span<const Vector3f> positions, float diameter, uint32_t size)
{
    Vector3f corner = positions[0];
    for (const Vector3f& p : positions) corner = corner.cwiseMin(p);
    const float pitch = static_cast<float>(size - 1);
    std::map<Cell, Members> boxes;
    for (uint32_t i = 0; i < positions.size(); ++i) {
        const Vector3f u = (positions[i] - corner) / diameter;
        Cell first{}, last{};
        for (int axis = 0; axis < 3; ++axis) {
            first[axis] = static_cast<int>(std::ceil((u[axis] - pitch - LATTICE_SLACK) / pitch));
            last[axis] = static_cast<int>(std::floor((u[axis] + LATTICE_SLACK) / pitch));
        }
        for (int x = first[0]; x <= last[0]; ++x)
            for (int y = first[1]; y <= last[1]; ++y)
                for (int z = first[2]; z <= last[2]; ++z) boxes[{x, y, z}].push_back(i);
    }
    return boxes;
}

/// Appends the connected parts of a box as clusters; single particles are left out.
void appendParts(std::vector<Members>& out, const Members& box, std::span<const Vector3f> positions, float diameter)
{
    DisjointSets sets(box.size());
    for (uint32_t a = 0; a < box.size(); ++a)
        for (uint32_t b = a + 1; b < box.size(); ++b)
            if (areNeighbours(positions[box[a]], positions[box[b]], diameter)) sets.unite(a, b);
    std::map<uint32_t, Members> parts;
    for (uint32_t a = 0; a < box.size(); ++a) parts[sets.find(a)].push_back(box[a]);
    for (auto& [root, members] : parts)
        if (members.size() > 1) out.push_back(std::move(members));
}

/// Removes clusters that are part of a larger one.
std::vector<Members> withoutContained(std::vector<Members> clusters, size_t particleCount)
{
    std::stable_sort(clusters.begin(), clusters.end(),
                     [](const Members& a, const Members& b) { return a.size() > b.size(); });
    std::vector<Members> kept;
    std::vector<std::vector<uint32_t>> of(particleCount);
    for (Members& members : clusters) {
        const auto contains = [&](uint32_t c) {
            return std::includes(kept[c].begin(), kept[c].end(), members.begin(), members.end());
        };
        if (std::any_of(of[members[0]].begin(), of[members[0]].end(), contains)) continue;
        for (uint32_t i : members) of[i].push_back(static_cast<uint32_t>(kept.size()));
        kept.push_back(std::move(members));
    }
    return kept;
}

/// Gives pairs of neighbours without a common box a cluster of their own if nothing else connects them: particles off
/// the lattice may be such.
void bridgeGaps(std::vector<Members>& clusters, std::span<const Vector3f> positions, float diameter)
{
    DisjointSets sets(positions.size());
    for (const Members& members : clusters)
        for (uint32_t i : members) sets.unite(members[0], i);
    Cells cells(NEIGHBOUR_DISTANCE * diameter);
    for (uint32_t i = 0; i < positions.size(); ++i) cells.add(positions[i], i);
    for (uint32_t i = 0; i < positions.size(); ++i)
        cells.forEachAround(positions[i], [&](uint32_t j) {
            if (j <= i || sets.find(i) == sets.find(j)) return;
            if (!areNeighbours(positions[i], positions[j], diameter)) return;
            clusters.push_back({i, j});
            sets.unite(i, j);
        });
}

/// The pinned particles of a body that are its outermost, seen from a neighbour by a face that is not.
std::vector<bool> endPins(const World& world, const SoftBody& soft, std::span<const Vector3f> positions)
{
    const float diameter = world.diameter();
    const auto isPinned = [&](uint32_t i) { return world.particles[soft.particleStart + i].pinned; };
    std::vector<bool> out(positions.size());
    Cells cells(NEIGHBOUR_DISTANCE * diameter);
    for (uint32_t i = 0; i < positions.size(); ++i) cells.add(positions[i], i);
    const auto isFilled = [&](const Vector3f& place) {
        bool filled = false;
        cells.forEachAround(
            place, [&](uint32_t i) { filled |= (positions[i] - place).norm() < 2 * LATTICE_SLACK * diameter; });
        return filled;
    };
    for (uint32_t i = 0; i < positions.size(); ++i) {
        if (!isPinned(i)) continue;
        cells.forEachAround(positions[i], [&](uint32_t j) {
            if (j == i || isPinned(j) || (positions[j] - positions[i]).norm() > (1 + LATTICE_SLACK) * diameter) return;
            if (!isFilled(2 * positions[i] - positions[j])) out[i] = true;
        });
    }
    return out;
}

/// @param shares of its particles' masses.
void appendCluster(World& world, uint32_t softBody, const Members& members, const std::vector<float>& shares)
{
    const SoftBody& soft = world.softBodies[softBody];
    const auto index = static_cast<uint32_t>(world.clusters.size());
    const auto linkStart = static_cast<uint32_t>(world.clusterLinks.size());
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double mass = 0.0;
    for (uint32_t member : members) {
        const Particle& particle = world.particles[soft.particleStart + member];
        const float share = particle.mass * shares[member];
        world.clusterLinks.push_back({soft.particleStart + member, index, particle.restPosition, share});
        centre += share * particle.restPosition.cast<double>();
        mass += share;
    }
    centre /= mass;
    for (uint32_t l = linkStart; l < world.clusterLinks.size(); ++l) {
        Vector3f& offset = world.clusterLinks[l].restOffset;
        offset = (offset.cast<double>() - centre).cast<float>();
    }
    world.clusters.push_back({softBody, linkStart, static_cast<uint32_t>(members.size())});
}

}  // namespace

std::vector<std::vector<uint32_t>> makeClusters(std::span<const Vector3f> positions, float diameter, uint32_t size)
{
    if (positions.empty()) return {};
    std::vector<Members> parts;
    for (const auto& [cell, members] : fillBoxes(positions, diameter, size))
        appendParts(parts, members, positions, diameter);
    std::vector<Members> clusters = withoutContained(std::move(parts), positions.size());
    bridgeGaps(clusters, positions, diameter);
    return clusters;
}

void makeSoftLinks(World& world)
{
    for (uint32_t b = 0; b < world.softBodies.size(); ++b) {
        SoftBody& soft = world.softBodies[b];
        soft.assembly = world.assemblyCount++;
        std::vector<Vector3f> positions;
        for (uint32_t i = soft.particleStart; i < soft.particleStart + soft.particleCount; ++i) {
            world.particles[i].assembly = soft.assembly;
            positions.push_back(world.particles[i].restPosition);
        }
        const auto clusters = makeClusters(positions, world.diameter());
        const std::vector<bool> ends = endPins(world, soft, positions);
        std::vector<float> shares(positions.size());
        for (const Members& members : clusters)
            for (uint32_t member : members) ++shares[member];
        // A body is held in the middle of its outermost layer: what is beyond is not strained.
        for (uint32_t i = 0; i < shares.size(); ++i) shares[i] = (ends[i] ? 0.5f : 1.0f) / shares[i];
        soft.clusterStart = static_cast<uint32_t>(world.clusters.size());
        soft.clusterCount = static_cast<uint32_t>(clusters.size());
        for (const Members& members : clusters) appendCluster(world, b, members, shares);
    }
}

}  // namespace knuckle
