#include "render/spheres/sphere_lists.h"

#include "shared/frame_types.h"

#include "render/render_groups.h"
#include "render/spheres/covered.h"

namespace knuckle {

namespace {

constexpr size_t CELL_COUNT = size_t{BURIAL_CELLS} * BURIAL_CELLS * BURIAL_CELLS;

/// Runs of at most LIST_CHUNK particles, with one more for the border between solids and fluids.
size_t runLimit(size_t particleCount)
{
    return (particleCount + LIST_CHUNK - 1) / LIST_CHUNK + 1;
}

std::vector<float> scalesOf(const World& world)
{
    std::vector<float> scales;
    for (const Particle& particle : world.particles) scales.push_back(particle.scale);
    return scales;
}

}  // namespace

SphereLists::SphereLists(const Gpu& gpu, BufferTable& table, const World& world, bool seesThrough)
    : particleCount_(static_cast<uint32_t>(world.particles.size())),
      covered_("coveredParticles", std::span<const uint32_t>(coveredParticles(world))),
      scales_("sphereScales", std::span<const float>(scalesOf(world))), drawKinds_("sphereDrawKinds", particleCount_),
      list_("sphereList", size_t{3} * particleCount_), cells_("burialCells", CELL_COUNT),
      buried_("buriedCells", CELL_COUNT), counts_("sphereCounts", runLimit(particleCount_)),
      draws_("sphereDraws", SPHERE_DRAWS)
{
    table.add(Lifetime::Constant, covered_, scales_);
    table.add(Lifetime::Scratch, drawKinds_, list_, cells_, buried_, counts_, draws_);
    Defines defines;
    if (coversParticles(world)) defines.push_back({"COVERED", "1"});
    if (seesThrough) defines.push_back({"SURFACES", "1"});
    const auto load = [&](const std::string& name) {
        return Kernel(gpu, table, "render/spheres/" + name + ".comp", defines);
    };
    burialCount_ = load("burial_count");
    burialCells_ = load("burial_cells");
    burialHidden_ = load("burial_hidden");
    cull_ = load("sphere_cull");
    offsets_ = load("sphere_offsets");
    write_ = load("sphere_list");
}

void SphereLists::update(KernelTimer& timer)
{
    if (particleCount_ == 0) return;
    cells_.clear();
    burialCount_.dispatch(timer, renderGroups(particleCount_));
    burialCells_.dispatch(timer, renderGroups(CELL_COUNT));
    burialHidden_.dispatch(timer, renderGroups(CELL_COUNT));
    cull_.dispatch(timer, renderGroups(runLimit(particleCount_)));
    offsets_.dispatch(timer, 1);
    write_.dispatch(timer, renderGroups(runLimit(particleCount_)));
}

void SphereLists::draw(KernelTimer& timer, const DrawPass& pass, SphereGroup group, uint32_t kind) const
{
    const GLenum primitive = kind == QUAD_DRAW ? GL_TRIANGLES : GL_POINTS;
    pass.drawIndirect(timer, primitive, draws_, DRAWS_PER_GROUP * static_cast<uint32_t>(group) + kind);
}

}  // namespace knuckle
