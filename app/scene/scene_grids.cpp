#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "app/json/fields.h"
#include "app/scene/scene_parts.h"
#include "render/picture/image.h"
#include "sim/base/errors.h"
#include "sim/rig/mesh/distance_grid.h"

namespace knuckle {

namespace {

struct Heights {
    uint64_t columns = 0, rows = 0;
    std::vector<float> values;  ///< [m], the row of the lowest z first.
};

/// Runs `make`, and adds the scene's file and JSON path to its error.
void atPointer(const SceneContext& context, const std::string& pointer, const std::function<void()>& make)
{
    try {
        make();
    } catch (const InputError& error) {
        failAt(context.path, pointer, error.what());
    }
}

Heights imageHeights(const std::string& file, float height)
{
    const GreyImage image = readGreyImage(file);
    Heights heights{image.width, image.height, {}};
    for (const float value : image.values) heights.values.push_back(height * value);
    return heights;
}

Heights listedHeights(const SceneContext& context, const Json& json, const std::string& pointer)
{
    Heights heights{json[0].size(), json.size(), {}};
    for (size_t row = 0; row < json.size(); ++row) {
        if (json[row].size() != heights.columns)
            failAt(context.path, fmt::format("{}/{}", pointer, row),
                   fmt::format("has {} heights, the first row has {}; give all as many", json[row].size(),
                               heights.columns));
        for (const Json& value : json[row]) heights.values.push_back(value.get<float>());
    }
    return heights;
}

Heights readHeights(SceneContext& context, const Json& json, const std::string& pointer)
{
    const bool listed = !json["heights"].empty();
    const std::string file = json["file"];
    if (listed != file.empty())
        failAt(context.path, pointer, "needs either `file` with an image or `heights`, and not both");
    if (listed) return listedHeights(context, json["heights"], pointer + "/heights");
    const std::string path = existingFile(context, file, pointer + "/file");
    Heights heights;
    atPointer(context, pointer + "/file", [&] { heights = imageHeights(path, json["height"]); });
    return heights;
}

}  // namespace

void addMeshGrid(SceneContext& context, const Json& json, const std::string& pointer, Collider& collider)
{
    const std::string file = existingFile(context, json["file"], pointer + "/file");
    const float given = json["cell"], cell = given > 0.0f ? given : context.builder.diameter();
    atPointer(context, pointer, [&] {
        const auto model = readModel(context, modelOf(json, file), false);
        collider.grid = context.builder.addColliderGrid(makeDistanceGrid(model->vertices, model->triangles, cell));
    });
    collider.shape = ColliderShape::Mesh;
}

void addHeightfield(SceneContext& context, const Json& json, const std::string& pointer, Collider& collider)
{
    Heights heights = readHeights(context, json, pointer);
    if (heights.columns < 2 || heights.rows < 2 || heights.values.size() > MAX_GRID_VALUES)
        failAt(context.path, pointer,
               fmt::format("has {} x {} heights; must be at least 2 x 2 and at most {} in all", heights.columns,
                           heights.rows, MAX_GRID_VALUES));
    const Eigen::Vector2f size(json["size"][0].get<float>(), json["size"][1].get<float>());
    collider.grid = context.builder.addColliderGrid(makeHeightfield(
        size, static_cast<int>(heights.columns), static_cast<int>(heights.rows), std::move(heights.values)));
    collider.shape = ColliderShape::Heightfield;
}

}  // namespace knuckle
