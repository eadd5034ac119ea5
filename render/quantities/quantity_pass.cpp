#include "render/quantities/quantity_pass.h"

#include <vector>

#include "render/quantities/color_scale.h"
#include "shared/draw_types.h"
#include "sim/base/errors.h"
#include "sim/gpu/filled_buffer.h"
#include "sim/solver/layout/cluster_links.h"

namespace knuckle {

namespace {

gpu::vec4 diagonalOf(const Eigen::Matrix3d& m)
{
    const Vector3f v = m.diagonal().cast<float>();
    return {v.x(), v.y(), v.z(), 0.0f};
}

gpu::vec4 besideOf(const Eigen::Matrix3d& m)
{
    return {static_cast<float>(m(0, 1)), static_cast<float>(m(0, 2)), static_cast<float>(m(1, 2)), 0.0f};
}

}  // namespace

QuantityPass::QuantityPass(const Gpu& gpu, BufferTable& table, const World& world, const RenderSettings& settings)
    : particleCount_(static_cast<uint32_t>(world.particles.size())), isPressure_(settings.colorBy == ColorBy::Pressure),
      quantity_(settings.colorBy)
{
    if (isKept(quantity_)) {
        table.add("shownQuantities", kept_, elementType<float>(), Lifetime::Scratch);
        return;
    }
    const bool isStrain = settings.colorBy == ColorBy::Strain;
    ofFluids_ = showsFluids(settings);
    const std::vector<float> none(ofFluids_ || isStrain ? particleCount_ : 0, NO_QUANTITY);
    shown_ = filledBuffer("shownQuantities", none);
    table.add(Lifetime::Scratch, shown_);
    if (ofFluids_) {
        addSlots(table);
        const Defines which = isPressure_ ? Defines{{"PRESSURE", "1"}} : Defines{};
        fluid_ = Kernel(gpu, table, "render/quantities/quantity_fluid.comp", which);
    }
    if (!isStrain) return;
    addClusters(table, world);
    cluster_ = Kernel(gpu, table, "render/quantities/quantity_cluster.comp");
    soft_ = Kernel(gpu, table, "render/quantities/quantity_soft.comp");
}

void QuantityPass::addSlots(BufferTable& table)
{
    table.add("particleSlots", particleSlots_, elementType<uint32_t>(), Lifetime::Scratch);
    table.add("slotParticles", slotParticles_, elementType<uint32_t>(), Lifetime::Scratch);
    table.add("slotPressures", slotPressures_, elementType<gpu::uvec4>(), Lifetime::Scratch);
    table.add("slotShapes", slotShapes_, elementType<gpu::vec4>(), Lifetime::Scratch);
    table.add("slotCovers", slotCovers_, elementType<gpu::vec4>(), Lifetime::Scratch);
}

void QuantityPass::addClusters(BufferTable& table, const World& world)
{
    std::vector<gpu::uvec2> clusters;
    std::vector<gpu::vec4> moments, links;
    std::vector<uint32_t> linked;
    std::vector<std::vector<uint32_t>> clustersOf(particleCount_);
    for (const Cluster& cluster : world.clusters) {
        const ClusterMoments m = clusterMoments(world, cluster);
        for (const Eigen::Matrix3d& matrix : {m.inverse, m.empty}) {
            moments.push_back(diagonalOf(matrix));
            moments.push_back(besideOf(matrix));
        }
        for (uint32_t l = cluster.linkStart; l < cluster.linkStart + cluster.linkCount; ++l)
            clustersOf[world.clusterLinks[l].particle].push_back(static_cast<uint32_t>(clusters.size()));
        clusters.push_back({cluster.linkStart, cluster.linkStart + cluster.linkCount});
    }
    for (const Link& link : world.clusterLinks) {
        links.push_back({link.restOffset.x(), link.restOffset.y(), link.restOffset.z(), link.mass});
        linked.push_back(link.particle);
    }
    std::vector<uint32_t> starts, all;
    for (const std::vector<uint32_t>& of : clustersOf) {
        starts.push_back(static_cast<uint32_t>(all.size()));
        all.insert(all.end(), of.begin(), of.end());
    }
    starts.push_back(static_cast<uint32_t>(all.size()));
    clusterCount_ = static_cast<uint32_t>(clusters.size());
    clusters_ = filledBuffer("shownClusters", clusters);
    moments_ = filledBuffer("shownMoments", moments);
    links_ = filledBuffer("shownLinks", links);
    linked_ = filledBuffer("shownLinked", linked);
    starts_ = filledBuffer("clusterStarts", starts);
    clustersOf_ = filledBuffer("particleClusters", all);
    strains_ = {"clusterStrains", clusters.size()};
    table.add(Lifetime::Constant, clusters_, moments_, links_, linked_, starts_, clustersOf_);
    table.add(Lifetime::Scratch, strains_);
}

void QuantityPass::attach(const ParticleView& view)
{
    if (isKept(quantity_)) {
        const GLuint kept = quantity_ == ColorBy::Age ? view.ages : view.contactForces;
        if (kept == 0)
            throw RunError("render.colorBy: these states have no ages or forces of contacts; render the scene");
        kept_ = RawBuffer::standIn("shownQuantities", kept, view.particleCount * sizeof(float));
        return;
    }
    if (!ofFluids_ || view.particleCount == view.solidCount) return;
    if (view.slotPressures == 0)
        throw RunError("render.colorBy: states on file have no pressures and densities of fluids; render the scene");
    const size_t count = view.particleCount;
    particleSlots_ = RawBuffer::standIn("particleSlots", view.particleSlots, count * sizeof(uint32_t));
    slotParticles_ = RawBuffer::standIn("slotParticles", view.slotParticles, count * sizeof(uint32_t));
    slotPressures_ = RawBuffer::standIn("slotPressures", view.slotPressures, 2 * count * sizeof(gpu::uvec4));
    slotShapes_ = RawBuffer::standIn("slotShapes", view.slotShapes, 2 * count * sizeof(gpu::vec4));
    slotCovers_ = RawBuffer::standIn("slotCovers", view.slotCovers, count * sizeof(gpu::vec4));
    if (isPressure_) glProgramUniform1f(fluid_.program(), 0, view.pressureUnit);
}

void QuantityPass::update(KernelTimer& timer) const
{
    if (ofFluids_ && slotPressures_.id() != 0) fluid_.dispatch(timer, groupsFor(particleCount_));
    if (clusterCount_ == 0) return;
    cluster_.dispatch(timer, groupsFor(clusterCount_));
    soft_.dispatch(timer, groupsFor(particleCount_));
}

}  // namespace knuckle
