#include "app/export/surface/surface.h"

#include <fmt/format.h>

#include "app/export/binary.h"
#include "sim/base/errors.h"

namespace knuckle {

std::vector<FluidDrop> dropsOf(const World& world, const ViewState& view)
{
    std::vector<FluidDrop> drops;
    for (size_t i = world.solidCount(); i < view.positions.size(); ++i) {
        const gpu::vec4& place = view.positions[i];
        if (place.w != 0.0f) continue;
        drops.push_back({{place.x, place.y, place.z}, {}});
        if (!view.fluidForms.empty()) drops.back().form = unpackSpheroid(view.fluidForms[i]);
    }
    return drops;
}

void SurfaceExport::begin(const Scene& scene)
{
    if (scene.world.fluidCount == 0)
        throw InputError(
            fmt::format("--export surface={}: the scene has no fluids, whose surface could be written", path()));
    FolderExport::begin(scene);
}

void SurfaceExport::frame(const ExportFrame& frame)
{
    const SurfaceMesh mesh = surfaceOf(FluidField(dropsOf(frame.world, *frame.view), frame.world.fluidSpacing));
    std::string text = fmt::format("ply\nformat binary_little_endian 1.0\ncomment frame {}\nelement vertex {}\n",
                                   frame.number, mesh.places.size());
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) text += fmt::format("property float {}\n", name);
    text += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n", mesh.triangles.size());
    for (size_t i = 0; i < mesh.places.size(); ++i) {
        appendBytes(text, mesh.places[i]);
        appendBytes(text, mesh.normals[i]);
    }
    for (const auto& triangle : mesh.triangles) {
        appendBytes(text, static_cast<uint8_t>(triangle.size()));
        appendBytes(text, triangle);
    }
    writeFile(names().path(frame.number), text);
}

}  // namespace knuckle
