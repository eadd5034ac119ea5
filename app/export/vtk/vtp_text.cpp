#include "app/export/vtk/vtp_text.h"

#include <fmt/format.h>

#include <numeric>
#include <span>

#include "app/export/binary.h"
#include "sim/base/base64.h"

namespace knuckle {

namespace {

constexpr const char* wordOf(float)
{
    return "Float32";
}
constexpr const char* wordOf(int32_t)
{
    return "Int32";
}
constexpr const char* wordOf(uint32_t)
{
    return "UInt32";
}

/// @param width numbers of a tuple.
template <typename T>
std::string dataArray(const char* name, const std::vector<T>& values, int width = 1)
{
    const uint64_t size = values.size() * sizeof(T);
    std::string bytes;
    appendBytes(bytes, size);
    bytes.append(reinterpret_cast<const char*>(values.data()), size);
    return fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">{}</DataArray>\n", wordOf(T{}),
        name, width, toBase64(bytes));
}

/// Strings are written as the numbers of their bytes, each ended by a 0. None: no array.
std::string nameArray(const char* name, const std::vector<std::string>& texts)
{
    if (texts.empty()) return "";
    std::string out = fmt::format("<Array type=\"String\" Name=\"{}\" NumberOfTuples=\"{}\" format=\"ascii\">", name,
                                  texts.size());
    for (const std::string& text : texts) {
        for (const char letter : text) out += fmt::format("{} ", static_cast<unsigned char>(letter));
        out += "0 ";
    }
    return out + "</Array>\n";
}

}  // namespace

std::string vtpText(const ParticlePoints& points, const VtpNames& names, double time)
{
    const size_t count = points.ids.size();
    std::vector<int32_t> places(count), ends(count);
    std::iota(places.begin(), places.end(), 0);
    std::iota(ends.begin(), ends.end(), 1);
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n";
    text += fmt::format("<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}"
                        "</DataArray>\n",
                        time);
    text += nameArray("bodyNames", names.bodies) + nameArray("materialNames", names.materials);
    text += fmt::format("</FieldData>\n<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\" NumberOfLines=\"0\" "
                        "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<Points>\n",
                        count);
    text += dataArray("Points", points.places, 3) + "</Points>\n<Verts>\n" + dataArray("connectivity", places) +
            dataArray("offsets", ends) + "</Verts>\n<PointData Scalars=\"body\" Vectors=\"velocity\">\n";
    text += dataArray("id", points.ids) + dataArray("body", points.bodies) + dataArray("material", points.materials) +
            dataArray("velocity", points.velocities, 3) + dataArray("radius", points.radii);
    if (!points.densities.empty()) text += dataArray("density", points.densities);
    return text + "</PointData>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace knuckle
