#include "sim/solver/joint/joint_stage.h"

namespace knuckle {

namespace {

constexpr const char* KIND = "joint";

bool isShared(const World& world, const Link& link)
{
    return world.particles[link.particle].bodyCount > 1;
}

/// Per link in the GPU's order: of those of shared particles, their row; NO_INDEX of others.
std::vector<uint32_t> rowsOfLinks(const StageSetup& setup)
{
    const std::vector<uint32_t> rows = setup.rows.rowsOf(KIND);
    std::vector<uint32_t> all;
    size_t next = 0;
    for (const uint32_t l : setup.layout.linkOrder)
        all.push_back(isShared(setup.world, setup.world.links[l]) ? rows[next++] : NO_INDEX);
    return all;
}

}  // namespace

void JointStage::reserveRows(RowPlan& rows, const World& world, const Layout& layout)
{
    for (const uint32_t l : layout.linkOrder) {
        const Link& link = world.links[l];
        if (isShared(world, link)) rows.reserve(KIND, link.body, link.restOffset);
    }
}

JointStage::JointStage(const StageSetup& setup)
    : parameters_(setup.parameters), byImpulses_(setup.world.settings.solver == SolverKind::Impulse),
      byTwo_(byImpulses_ && setup.layout.sharedByTwo > 0),
      byMany_(byImpulses_ && setup.layout.sharedParticles.size() > setup.layout.sharedByTwo)
{
    const Layout& layout = setup.layout;
    std::vector<gpu::uvec4> owners;
    for (uint32_t k = 0; k < layout.sharedByTwo; ++k) {
        const auto& both = layout.owners[layout.sharedParticles[k]];
        owners.push_back({both[0].link, both[0].body, both[1].link, both[1].body});
    }
    sharedParticles = {"sharedParticles", std::span<const uint32_t>(layout.sharedParticles)};
    sharedOwners = {"sharedOwners", std::span<const gpu::uvec4>(owners)};
    linkRows = {"linkRows", std::span<const uint32_t>(rowsOfLinks(setup))};
    setup.parameters.sharedCount = static_cast<uint32_t>(layout.sharedParticles.size());
    setup.parameters.sharedByTwo = layout.sharedByTwo;
    setup.parameters.jointRelaxation = 1.8f;
}

void JointStage::addBuffers(BufferTable& table)
{
    table.add(sharedParticles, sharedOwners, linkRows);
}

void JointStage::solve(Recorder& recorder, bool first) const
{
    recorder.perElement(first ? solveFirst_ : solve_, parameters_.sharedByTwo);
    recorder.perElement(first ? solveManyFirst_ : solveMany_, parameters_.sharedCount - parameters_.sharedByTwo);
}

void JointStage::placeParticles(Recorder& recorder) const
{
    recorder.perElement(place_, parameters_.sharedCount);
}

}  // namespace knuckle
