#include "app/export/frame_export.h"

#include <stdexcept>

namespace knuckle {

void exportFrame(const FrameRecord& record, const World& world, const ExportNeeds& needs, const Exporters& exporters)
{
    std::optional<ParticleState> particles;
    std::optional<std::vector<BodyState>> bodies = record.bodies;
    if (needs.particles && record.view) particles = particleState(*record.view);
    if (needs.bodies && !bodies && record.view) bodies = bodyStates(world, *record.view);
    if ((needs.views && !record.view) || (needs.particles && !particles) || (needs.bodies && !bodies) ||
        (needs.measures && !record.measures))
        throw std::logic_error("a frame lacks what its exporters need");
    const ExportFrame frame{.number = record.number,
                            .world = world,
                            .view = record.view ? &*record.view : nullptr,
                            .particles = particles ? &*particles : nullptr,
                            .bodies = bodies ? &*bodies : nullptr,
                            .measures = record.measures ? &*record.measures : nullptr,
                            .densities = record.densities ? &*record.densities : nullptr};
    for (const auto& exporter : exporters) exporter->frame(frame);
}

void passFrame(const FrameRecord& record, const World& world, const Exporters& exporters)
{
    if (!needsOf(exporters).views) return;
    if (!record.view) throw std::logic_error("a frame lacks what its exporters need");
    const ExportFrame frame{.number = record.number, .world = world, .view = &*record.view};
    for (const auto& exporter : exporters)
        if (exporter->needs().views) exporter->pass(frame);
}

OpenExporters::OpenExporters(const Exporters& exporters, Gpu& gpu) : exporters_(exporters)
{
    for (const auto& exporter : exporters) exporter->open(gpu);
}

OpenExporters::~OpenExporters()
{
    for (const auto& exporter : exporters_) exporter->close();
}

}  // namespace knuckle
