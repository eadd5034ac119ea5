#include "sim/rig/bodies/part_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "sim/base/errors.h"
#include "sim/base/short_list.h"
#include "sim/rig/bodies/bone_bodies.h"
#include "sim/rig/mesh/polyhedron.h"

namespace knuckle {

namespace {

constexpr size_t FEWEST = 12;  // least particles of a part that is a body

using Particles = std::vector<uint32_t>;

uint32_t partOf(const Model& model, const Triangle& triangle)
{
    return model.skin[triangle[0]].bones[0];
}

std::vector<std::vector<Triangle>> trianglesOfParts(const Model& model)
{
    std::vector<std::vector<Triangle>> triangles(model.bones.size());
    for (const Triangle& triangle : model.triangles) triangles[partOf(model, triangle)].push_back(triangle);
    return triangles;
}

/// Finds the part of a particle: the one that it is inside of, else the one whose surface is nearest. Where two parts
/// touch, their surfaces are equally near.
class PartFinder {
public:
    explicit PartFinder(const Model& model) : model_(model), triangles_(trianglesOfParts(model))
    {
        for (const std::vector<Triangle>& triangles : triangles_) {
            Eigen::AlignedBox3f& bounds = bounds_.emplace_back();
            for (const Triangle& triangle : triangles)
                for (const uint32_t corner : triangle) bounds.extend(model.vertices[corner]);
            trees_.emplace_back(model.vertices, triangles);
        }
    }

    uint32_t at(const Vector3f& position, const SurfacePoint& nearest) const
    {
        uint32_t found = NO_INDEX;
        for (uint32_t part = 0; part < trees_.size(); ++part) {
            if (!bounds_[part].contains(position) || !trees_[part].inside(position)) continue;
            if (found != NO_INDEX) return partOf(model_, model_.triangles[nearest.triangle]);
            found = part;
        }
        return found != NO_INDEX ? found : partOf(model_, model_.triangles[nearest.triangle]);
    }

private:
    const Model& model_;
    std::vector<std::vector<Triangle>> triangles_;  ///< Per part, as all that follow.
    std::vector<Eigen::AlignedBox3f> bounds_;
    std::vector<TriangleTree> trees_;
};

/// The parts that are bodies: those with enough particles, or if there are none the one with the most.
std::vector<uint32_t> largeParts(const std::vector<Particles>& particles)
{
    std::vector<uint32_t> large;
    for (uint32_t p = 0; p < particles.size(); ++p)
        if (particles[p].size() >= FEWEST) large.push_back(p);
    if (large.empty()) {
        const auto most = std::ranges::max_element(particles, {}, &Particles::size);
        large.push_back(static_cast<uint32_t>(most - particles.begin()));
    }
    return large;
}

/// @throws InputError for a part that is to be a body and has no particles.
std::vector<uint32_t> plannedParts(const Model& model, const std::vector<Particles>& particles, const BodyPlan& plan)
{
    std::vector<uint32_t> large;
    for (uint32_t p = 0; p < particles.size(); ++p) {
        if (!plan.hasBody(p)) continue;
        if (particles[p].empty())
            throw InputError(fmt::format("{}: the part {}, a body at the coarsest level, has no particles; add a "
                                         "coarser level, or leave this one out",
                                         model.name, model.bones[p].name));
        large.push_back(p);
    }
    return large;
}

/// Among some parts, the one with the particle nearest to a point.
uint32_t nearestPart(const std::vector<uint32_t>& parts, const std::vector<Particles>& particles, const Voxels& voxels,
                     const Vector3f& point)
{
    float nearest = std::numeric_limits<float>::infinity();
    uint32_t found = parts.front();
    for (const uint32_t part : parts) {
        for (const uint32_t particle : particles[part]) {
            const float distance = (voxels.positions[particle] - point).squaredNorm();
            if (distance < nearest) found = part;
            nearest = std::min(nearest, distance);
        }
    }
    return found;
}

/// The particles of each part, where all are convex polyhedra, and not all are boxes along the axes; else none.
std::vector<Particles> fillPolyhedra(const Model& model, float diameter, Voxels& voxels)
{
    std::vector<Particles> particles;
    bool allBoxes = true;
    for (const std::vector<Triangle>& triangles : trianglesOfParts(model)) {
        const Solid part(model.vertices, triangles);
        const std::vector<Facet> facets = facetsOf(part);
        allBoxes = allBoxes && isBoxAlongAxes(facets);
        Particles& own = particles.emplace_back();
        for (const Vector3f& place : fillPolyhedron(facets, diameter)) {
            own.push_back(static_cast<uint32_t>(voxels.positions.size()));
            voxels.add(part, place);
        }
        if (own.empty()) return {};
    }
    return allBoxes ? std::vector<Particles>() : particles;
}

/// The particles of each part on a lattice that all share.
std::vector<Particles> shareLattice(const Model& model, const Voxels& voxels)
{
    std::vector<Particles> particles(model.bones.size());
    const PartFinder finder(model);
    for (uint32_t p = 0; p < voxels.positions.size(); ++p)
        particles[finder.at(voxels.positions[p], voxels.nearest[p])].push_back(p);
    return particles;
}

}  // namespace

Actor partBodies(const Model& model, const Solid& solid, const ActorOptions& options)
{
    const Voxels lattice = voxelize(solid, options.voxels);
    Voxels facets;
    facets.diameter = lattice.diameter;
    std::vector<Particles> particles = fillPolyhedra(model, lattice.diameter, facets);
    const Voxels& voxels = particles.empty() ? lattice : facets;
    if (particles.empty()) particles = shareLattice(model, lattice);
    Actor actor;
    actor.name = options.name.empty() ? model.name : options.name;
    actor.diameter = voxels.diameter;
    actor.particles = voxels.positions;
    actor.signedDistances = voxels.signedDistances;
    actor.outward = voxels.outward;
    actor.notes = model.notes;
    const BodyPlan& plan = options.plan;
    const std::vector<uint32_t> large = plan.empty() ? largeParts(particles) : plannedParts(model, particles, plan);
    std::vector<uint32_t> owner(particles.size());
    std::vector<std::string> small;
    for (uint32_t p = 0; p < particles.size(); ++p) {
        const bool isLarge = std::ranges::binary_search(large, p);
        owner[p] = isLarge         ? p
                   : !plan.empty() ? plan.owners[p]
                                   : nearestPart(large, particles, voxels, boneHead(model, p));
        if (!isLarge) small.push_back(model.bones[p].name);
    }
    for (const uint32_t part : large) {
        ActorBody body{model.bones[part].name, {}, -1, {}};
        for (uint32_t p = 0; p < particles.size(); ++p) {
            if (owner[p] != part) continue;
            body.particles.insert(body.particles.end(), particles[p].begin(), particles[p].end());
            if (p != part) body.mergedBones.push_back(model.bones[p].name);
        }
        std::ranges::sort(body.particles);
        actor.bodies.push_back(std::move(body));
    }
    if (!small.empty())
        actor.notes.push_back(
            fmt::format("Parts of less than {} particles went to the nearest: {}.", FEWEST, shortList(small)));
    numberAsAdded(actor);
    return actor;
}

}  // namespace knuckle
