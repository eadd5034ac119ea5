#include "app/scene/scene_draw.h"

#include <fmt/format.h>

namespace knuckle {

bool isDrawnAs(const ObjectEntry& entry, DrawnAs has, const std::string& what, uint32_t of)
{
    const std::string draw = entry.json.value("draw", "particles");
    const std::string own = has == DrawnAs::Shape ? "shape" : "surface";
    const std::string other = has == DrawnAs::Shape ? "surface" : "shape";
    if (draw == other) entry.fail("/draw", fmt::format("{} has no {}; take \"{}\" or \"particles\"", what, other, own));
    if (draw != "auto") return draw == own;
    const Material& material = entry.context.builder.material(of == NO_INDEX ? entry.material : of);
    if (material.look.drawn == DrawnAs::Surface && has == DrawnAs::Shape)
        entry.fail("/material", fmt::format("\"{}\" says \"draw\": \"surface\", and {} has none; give it \"draw\": "
                                            "\"shape\" or \"particles\", or another material",
                                            material.name, what));
    return material.look.drawn == has;
}

}  // namespace knuckle
