#include "app/export/points/bgeo.h"

#include <array>
#include <string_view>

#include "app/export/binary.h"
#include "app/export/points/particle_points.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

/// Types of attributes.
constexpr int32_t FLOAT = 0, INTEGER = 1, VECTOR = 5;
constexpr int32_t VERSION = 5;

/// The most significant byte first.
template <typename T>
void appendBig(std::string& out, T value)
{
    std::string bytes;
    appendBytes(bytes, value);
    out.append(bytes.rbegin(), bytes.rend());
}

/// What a point has besides its place: name, number of values, type, and a default for each.
void appendAttribute(std::string& out, std::string_view name, uint16_t size, int32_t type)
{
    appendBig(out, static_cast<uint16_t>(name.size()));
    out += name;
    appendBig(out, size);
    appendBig(out, type);
    for (uint16_t k = 0; k < size; ++k) appendBig(out, int32_t{0});
}

std::string bgeoText(const ParticlePoints& points)
{
    const bool hasDensities = !points.densities.empty();
    std::string text = "BgeoV";
    // Points; primitives, and groups of both; attributes of points; of vertices, of primitives, of the whole.
    const std::array counts{static_cast<int32_t>(points.ids.size()), 0, 0, 0, hasDensities ? 6 : 5, 0, 0, 0};
    appendBig(text, VERSION);
    for (const int32_t count : counts) appendBig(text, count);
    appendAttribute(text, "v", 3, VECTOR);
    appendAttribute(text, "id", 1, INTEGER);
    appendAttribute(text, "body", 1, INTEGER);
    appendAttribute(text, "material", 1, INTEGER);
    appendAttribute(text, "pscale", 1, FLOAT);
    if (hasDensities) appendAttribute(text, "density", 1, FLOAT);
    for (size_t i = 0; i < points.ids.size(); ++i) {
        for (size_t k = 0; k < 3; ++k) appendBig(text, points.places[3 * i + k]);
        appendBig(text, 1.0f);  // the weight of the place
        for (size_t k = 0; k < 3; ++k) appendBig(text, points.velocities[3 * i + k]);
        appendBig(text, points.ids[i]);
        appendBig(text, points.bodies[i]);
        appendBig(text, points.materials[i]);
        appendBig(text, points.radii[i]);
        if (hasDensities) appendBig(text, points.densities[i]);
    }
    text += '\0';
    text += '\xff';
    return text;
}

}  // namespace

void BgeoExport::frame(const ExportFrame& frame)
{
    writeFile(names().path(frame.number), bgeoText(pointsOf(frame)));
}

}  // namespace knuckle
