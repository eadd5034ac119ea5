#include "app/export/points/ply.h"

#include <fmt/format.h>

#include "app/export/binary.h"
#include "app/export/points/particle_points.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

/// A line for each material: its index and name, without characters that end the line.
std::string materialComments(const World& world)
{
    std::string out;
    for (size_t i = 0; i < world.materials.size(); ++i) {
        std::string name = world.materials[i].name;
        std::erase_if(name, [](unsigned char c) { return c < ' '; });
        out += fmt::format("comment material {} {}\n", i, name);
    }
    return out;
}

}  // namespace

void PlyExport::frame(const ExportFrame& frame)
{
    const ParticlePoints points = pointsOf(frame);
    std::string text = fmt::format("ply\nformat binary_little_endian 1.0\ncomment frame {}\nelement vertex {}\n",
                                   frame.number, points.ids.size());
    text.insert(text.find("element"), materialComments(frame.world));
    text += "property uint id\nproperty float x\nproperty float y\nproperty float z\nproperty float vx\n"
            "property float vy\nproperty float vz\nproperty int body\nproperty uint material\nend_header\n";
    for (size_t i = 0; i < points.ids.size(); ++i) {
        appendBytes(text, points.ids[i]);
        for (size_t k = 0; k < 3; ++k) appendBytes(text, points.places[3 * i + k]);
        for (size_t k = 0; k < 3; ++k) appendBytes(text, points.velocities[3 * i + k]);
        appendBytes(text, points.bodies[i]);
        appendBytes(text, points.materials[i]);
    }
    writeFile(names().path(frame.number), text);
}

}  // namespace knuckle
