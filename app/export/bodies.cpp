#include "app/export/bodies.h"

#include <fmt/format.h>

namespace knuckle {

namespace {

/// A CSV field, quoted if necessary.
std::string field(const std::string& text)
{
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + '"';
}

}  // namespace

void BodyExport::begin(const Scene& /*scene*/)
{
    file_.emplace(path());
    file_->write("frame,body,object,name,x,y,z,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz\n");
}

void BodyExport::frame(const ExportFrame& frame)
{
    std::string text;
    for (size_t i = 0; i < frame.bodies->size(); ++i) {
        const BodyState& state = (*frame.bodies)[i];
        const Body& body = frame.world.bodies[i];
        const std::string object = body.object == NO_INDEX ? "" : frame.world.objects[body.object].name;
        text += fmt::format("{},{},{},{}", frame.number, i, field(object), field(body.name));
        for (const float value : state.position) text += fmt::format(",{}", value);
        for (const float value : state.rotation.coeffs()) text += fmt::format(",{}", value);
        for (const float value : state.velocity) text += fmt::format(",{}", value);
        for (const float value : state.angularVelocity) text += fmt::format(",{}", value);
        text += '\n';
    }
    file_->write(text);
}

}  // namespace knuckle
