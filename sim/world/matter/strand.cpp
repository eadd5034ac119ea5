#include "sim/world/matter/strand.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/base/disjoint_sets.h"
#include "sim/base/errors.h"
#include "sim/world/world.h"

namespace knuckle {

namespace {

/// Rest lengths may exceed a diameter by rounding.
constexpr float LENGTH_TOLERANCE = 1.001f;

const char* nameOf(DistanceKind kind)
{
    return kind == DistanceKind::Stretch ? "stretch" : kind == DistanceKind::Shear ? "shear" : "bend";
}

void checkStrand(const World& world, const Strand& strand, size_t index)
{
    const auto fail = [&](const std::string& what) {
        throw InputError(fmt::format("strand {} ({}): {}", index, nameOf(strand.kind), what));
    };
    const auto misuse = [&](const std::string& what) {
        throw std::logic_error(fmt::format("strand {} ({}): {}", index, nameOf(strand.kind), what));
    };
    if (strand.particles.size() < 2) misuse("has fewer than 2 particles; make it longer");
    if (strand.restLengths.size() + 1 != strand.particles.size())
        misuse(fmt::format("{} particles and {} distances; there must be one distance less", strand.particles.size(),
                           strand.restLengths.size()));
    if (!(strand.compliance >= 0.0f) || !std::isfinite(strand.compliance))
        misuse(fmt::format("compliance {} m/N must be 0 (rigid) or above", strand.compliance));
    if (!(strand.startRelease > 0.0f && strand.endRelease > 0.0f))
        fail(fmt::format("lets go at {} s; give it a time above 0", std::min(strand.startRelease, strand.endRelease)));
    if (!(strand.tearForce > 0.0f)) fail(fmt::format("tear force {} N must be above 0", strand.tearForce));
    for (float length : strand.restLengths) {
        if (!(length > 0.0f) || !std::isfinite(length)) fail(fmt::format("rest distance {} m must be above 0", length));
        if (strand.kind == DistanceKind::Stretch && length > LENGTH_TOLERANCE * world.diameter())
            fail(fmt::format("rest distance {} m is above the diameter, {} m, and things would fall through; add "
                             "particles in between or raise the diameter",
                             length, world.diameter()));
    }
    std::vector<uint32_t> sorted = strand.particles;
    std::sort(sorted.begin(), sorted.end());
    if (sorted.back() >= world.particles.size()) misuse(fmt::format("there is no particle {}", sorted.back()));
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) fail("has a particle twice");
    for (uint32_t particle : strand.particles)
        if (world.particles[particle].bodyCount > 1)
            fail(fmt::format("particle {} belongs to {} bodies; attach to one that belongs to one", particle,
                             world.particles[particle].bodyCount));
}

}  // namespace

void joinStrandAssemblies(World& world)
{
    if (world.strands.empty()) return;
    DisjointSets sets(world.assemblyCount);
    for (const Strand& strand : world.strands) {
        for (uint32_t index : strand.particles) {
            Particle& particle = world.particles.at(index);
            if (particle.assembly == NO_INDEX) particle.assembly = sets.add();
        }
        for (uint32_t index : strand.particles)
            sets.unite(world.particles[strand.particles[0]].assembly, world.particles[index].assembly);
    }
    // Numbers them anew, without gaps.
    std::vector<uint32_t> number(sets.size(), NO_INDEX);
    std::vector<bool> joined(sets.size(), false);
    world.assemblyCount = 0;
    for (uint32_t a = 0; a < sets.size(); ++a)
        number[a] = sets.find(a) == a ? world.assemblyCount++ : number[sets.find(a)];
    for (const Strand& strand : world.strands)
        for (uint32_t index : strand.particles) joined[number[world.particles[index].assembly]] = true;
    for (Body& body : world.bodies) body.assembly = number[body.assembly];
    for (Particle& particle : world.particles) {
        if (particle.assembly == NO_INDEX) continue;
        particle.assembly = number[particle.assembly];
        if (joined[particle.assembly]) particle.restPosition = particle.position;
    }
}

void validateStrands(const World& world)
{
    if (!world.strands.empty() && world.settings.solver == SolverKind::Paper)
        throw InputError("ropes and cloth need the default solver; set /solver/method to \"impulse\"");
    for (size_t i = 0; i < world.strands.size(); ++i) checkStrand(world, world.strands[i], i);
}

}  // namespace knuckle
