#include "app/export/ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <filesystem>

#include "sim/base/files/output_file.h"
#include "sim/base/files/output_place.h"

namespace knuckle {

namespace {

static_assert(std::endian::native == std::endian::little, "the PLY writer copies values as they lie in memory");

template <typename T>
void append(std::string& out, const T& value)
{
    out.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

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

void PlyExport::addPaths(const Scene& /*scene*/, RunPaths& paths) const
{
    paths.writesFrames(names());
}

void PlyExport::begin(const Scene& /*scene*/)
{
    requireWritableFolder(path());
}

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
        append(text, i);
        for (const Vector3f& vector : {state.positions[i], state.velocities[i]}) {
            for (int axis = 0; axis < 3; ++axis) append(text, vector[axis]);
        }
        append(text, static_cast<int32_t>(particle.body));  // NO_INDEX becomes -1
        append(text, particle.material);
    }
    OutputFile file(names().path(frame.number));
    file.write(text);
    file.commit();
}

}  // namespace knuckle
