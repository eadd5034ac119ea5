#include "app/export/points/ply.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/export/binary.h"
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
    const ParticleState& state = *frame.particles;
    const auto there = std::count(state.inactive.begin(), state.inactive.end(), false);
    std::string text = fmt::format("ply\nformat binary_little_endian 1.0\ncomment frame {}\nelement vertex {}\n",
                                   frame.number, there);
    text.insert(text.find("element"), materialComments(frame.world));
    text += "property uint id\nproperty float x\nproperty float y\nproperty float z\nproperty float vx\n"
            "property float vy\nproperty float vz\nproperty int body\nproperty uint material\nend_header\n";
    for (uint32_t i = 0; i < state.positions.size(); ++i) {
        if (state.inactive[i]) continue;
        const Particle& particle = frame.world.particles[i];
        appendBytes(text, i);
        appendBytes(text, state.positions[i]);
        appendBytes(text, state.velocities[i]);
        appendBytes(text, static_cast<int32_t>(particle.body));  // NO_INDEX becomes -1
        appendBytes(text, particle.material);
    }
    writeFile(names().path(frame.number), text);
}

}  // namespace knuckle
