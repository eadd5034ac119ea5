#include "sim/world/distance_row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/world/disjoint_sets.h"
#include "sim/world/errors.h"
#include "sim/world/world.h"

namespace knuckle {

namespace {

/// Rest lengths may exceed a diameter by rounding.
constexpr float LENGTH_TOLERANCE = 1.001f;

const char* nameOf(DistanceKind kind)
{
    return kind == DistanceKind::Stretch ? "stretch" : kind == DistanceKind::Shear ? "shear" : "bend";
}

void checkDistanceRow(const World& world, const DistanceRow& row, size_t index)
{
    const auto fail = [&](const std::string& what) {
        throw InputError(fmt::format("distance row {} ({}): {}", index, nameOf(row.kind), what));
    };
    const auto misuse = [&](const std::string& what) {
        throw std::logic_error(fmt::format("distance row {} ({}): {}", index, nameOf(row.kind), what));
    };
    if (row.particles.size() < 2) misuse("has fewer than 2 particles; make it longer");
    if (row.restLengths.size() + 1 != row.particles.size())
        misuse(fmt::format("{} particles and {} distances; there must be one distance less", row.particles.size(),
                           row.restLengths.size()));
    if (!(row.compliance >= 0.0f) || !std::isfinite(row.compliance))
        misuse(fmt::format("compliance {} m/N must be 0 (rigid) or above", row.compliance));
    if (!(row.tearForce > 0.0f)) fail(fmt::format("tear force {} N must be above 0", row.tearForce));
    for (float length : row.restLengths) {
        if (!(length > 0.0f) || !std::isfinite(length)) fail(fmt::format("rest distance {} m must be above 0", length));
        if (row.kind == DistanceKind::Stretch && length > LENGTH_TOLERANCE * world.diameter())
            fail(fmt::format("rest distance {} m is above the diameter, {} m, and things would fall through; add "
                             "particles in between or raise the diameter",
                             length, world.diameter()));
    }
    std::vector<uint32_t> sorted = row.particles;
    std::sort(sorted.begin(), sorted.end());
    if (sorted.back() >= world.particles.size()) misuse(fmt::format("there is no particle {}", sorted.back()));
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) fail("has a particle twice");
    for (uint32_t particle : row.particles)
        if (world.particles[particle].bodyCount > 1)
            fail(fmt::format("particle {} belongs to {} bodies; attach to one that belongs to one", particle,
                             world.particles[particle].bodyCount));
}

}  // namespace

void joinRowAssemblies(World& world)
{
    if (world.distanceRows.empty()) return;
    DisjointSets sets(world.assemblyCount);
    for (const DistanceRow& row : world.distanceRows) {
        for (uint32_t index : row.particles) {
            Particle& particle = world.particles.at(index);
            if (particle.assembly == NO_INDEX) particle.assembly = sets.add();
        }
        for (uint32_t index : row.particles)
            sets.unite(world.particles[row.particles[0]].assembly, world.particles[index].assembly);
    }
    // Numbered anew, without gaps.
    std::vector<uint32_t> number(sets.size(), NO_INDEX);
    std::vector<bool> joined(sets.size(), false);
    world.assemblyCount = 0;
    for (uint32_t a = 0; a < sets.size(); ++a)
        number[a] = sets.find(a) == a ? world.assemblyCount++ : number[sets.find(a)];
    for (const DistanceRow& row : world.distanceRows)
        for (uint32_t index : row.particles) joined[number[world.particles[index].assembly]] = true;
    for (Body& body : world.bodies) body.assembly = number[body.assembly];
    for (Particle& particle : world.particles) {
        if (particle.assembly == NO_INDEX) continue;
        particle.assembly = number[particle.assembly];
        if (joined[particle.assembly]) particle.restPosition = particle.position;
    }
}

void validateDistanceRows(const World& world)
{
    if (!world.distanceRows.empty() && world.settings.solver == SolverKind::Paper)
        throw InputError("ropes and cloth need the default solver; set /solver/method to \"impulse\"");
    for (size_t i = 0; i < world.distanceRows.size(); ++i) checkDistanceRow(world, world.distanceRows[i], i);
}

}  // namespace knuckle
