#include "app/export/bodies.h"

#include <fmt/format.h>

#include "app/export/csv.h"

namespace knuckle {

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
        text += fmt::format("{},{},{},{}", frame.number, i, csvCell(object), csvCell(body.name));
        for (const float value : state.position) text += fmt::format(",{}", value);
        for (const float value : state.rotation.coeffs()) text += fmt::format(",{}", value);
        for (const float value : state.velocity) text += fmt::format(",{}", value);
        for (const float value : state.angularVelocity) text += fmt::format(",{}", value);
        text += '\n';
    }
    file_->write(text);
}

}  // namespace knuckle
