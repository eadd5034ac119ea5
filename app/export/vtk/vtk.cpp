#include "app/export/vtk/vtk.h"

#include <fmt/format.h>

#include "app/export/vtk/vtp_text.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

VtpNames namesOf(const World& world)
{
    VtpNames names;
    for (const Body& body : world.bodies)
        names.bodies.push_back(
            body.object == NO_INDEX ? body.name : fmt::format("{}/{}", world.objects[body.object].name, body.name));
    for (const Material& material : world.materials) names.materials.push_back(material.name);
    return names;
}

/// Half of what it keeps from its like [m].
float radiusOf(const World& world, uint32_t particle)
{
    if (particle >= world.solidCount()) return 0.5f * world.fluidSpacing;
    return world.particleRadius * world.particles[particle].scale;
}

VtpPoints pointsOf(const ExportFrame& frame)
{
    const ParticleState& state = *frame.particles;
    VtpPoints points;
    for (uint32_t i = 0; i < state.positions.size(); ++i) {
        if (state.inactive[i]) continue;
        const Particle& particle = frame.world.particles[i];
        points.ids.push_back(i);
        for (int axis = 0; axis < 3; ++axis) points.places.push_back(state.positions[i][axis]);
        for (int axis = 0; axis < 3; ++axis) points.velocities.push_back(state.velocities[i][axis]);
        points.bodies.push_back(static_cast<int32_t>(particle.body));  // NO_INDEX becomes -1
        points.materials.push_back(static_cast<int32_t>(particle.material));
        points.radii.push_back(radiusOf(frame.world, i));
        if (frame.densities == nullptr) continue;
        const uint32_t solids = frame.world.solidCount();
        points.densities.push_back(frame.world.materials[particle.material].density *
                                   (i < solids ? 1.0f : (*frame.densities)[i - solids]));
    }
    return points;
}

}  // namespace

void VtkExport::addPaths(const Scene& scene, RunPaths& paths) const
{
    FolderExport::addPaths(scene, paths);
    paths.writes(series());
}

void VtkExport::begin(const Scene& scene)
{
    framesPerSecond_ = scene.framesPerSecond;
    FolderExport::begin(scene);
}

void VtkExport::frame(const ExportFrame& frame)
{
    const double time = static_cast<double>(frame.number - 1) / framesPerSecond_;
    writeFile(names().path(frame.number), vtpText(pointsOf(frame), namesOf(frame.world), time));
    frames_.push_back(frame.number);
}

void VtkExport::finish()
{
    const std::string folder = path() + "/";
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
    for (const uint64_t frame : frames_)
        text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n",
                            static_cast<double>(frame - 1) / framesPerSecond_,
                            names().path(frame).substr(folder.size()));
    writeFile(series(), text + "</Collection>\n</VTKFile>\n");
}

}  // namespace knuckle
