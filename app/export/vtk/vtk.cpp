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
