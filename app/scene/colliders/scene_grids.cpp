#include "app/scene/colliders/scene_grids.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "app/json/fields.h"
#include "render/picture/image.h"
#include "sim/base/errors.h"
#include "sim/rig/mesh/distance_grid.h"
#include "sim/rig/mesh/open_edges.h"

namespace knuckle {

namespace {

struct Heights {
    uint64_t columns = 0, rows = 0;
    std::vector<float> values;  ///< [m], the row of the lowest z first.
};

/// Runs `make`, and adds the scene's file and the field's JSON path to its errors.
void atField(const SceneEntry& entry, const std::string& field, const std::function<void()>& make)
{
    try {
        make();
    } catch (const InputError& error) {
        entry.fail(field, error.what());
    }
}

Heights imageHeights(const std::string& file, float height)
{
    const GreyImage image = readGreyImage(file);
    Heights heights{image.width, image.height, {}};
    for (const float value : image.values) heights.values.push_back(height * value);
    return heights;
}

Heights listedHeights(const SceneEntry& entry)
{
    const Json& json = entry.json["heights"];
    Heights heights{json[0].size(), json.size(), {}};
    for (size_t row = 0; row < json.size(); ++row) {
        if (json[row].size() != heights.columns)
            entry.fail(fmt::format("/heights/{}", row),
                       fmt::format("has {} heights, the first row has {}; give all as many", json[row].size(),
                                   heights.columns));
        for (const Json& value : json[row]) heights.values.push_back(value.get<float>());
    }
    return heights;
}

Heights readHeights(const SceneEntry& entry)
{
    const Json& json = entry.json;
    const bool listed = !json["heights"].empty();
    const std::string file = json["file"];
    if (listed != file.empty()) entry.fail("", "needs either `file` with an image or `heights`, and not both");
    if (listed) return listedHeights(entry);
    const std::string path = entry.context.files.existing(file, entry.pointer + "/file");
    Heights heights;
    atField(entry, "/file", [&] { heights = imageHeights(path, json["height"]); });
    return heights;
}

/// Distance of the values of a mesh's grid [m]. A sheet's middle is a ridge that the grid rounds off by a cell: the
/// centre of a fluid particle at its side, the nearest of all, must be beyond that.
float cellOf(const SceneEntry& entry, float thickness)
{
    const float given = entry.json["cell"];
    if (thickness == 0.0f) return given > 0.0f ? given : entry.context.builder.diameter();
    const float centre = 0.5f * (thickness + entry.context.builder.world().fluidSpacing);
    if (given > centre)
        entry.fail("/cell", fmt::format("{:g} m do not see a sheet of {:g} m; lower it to {:.2g} or less, or raise "
                                        "`thickness`",
                                        given, thickness, 0.5f * centre));
    return given > 0.0f ? given : 0.5f * centre;
}

}  // namespace

void addMeshGrid(const SceneEntry& entry, Collider& collider)
{
    const Json& json = entry.json;
    SceneContext& context = entry.context;
    WorldBuilder& builder = context.builder;
    const std::string file = context.files.existing(json["file"], entry.pointer + "/file");
    const float thickness = json["thickness"], cell = cellOf(entry, thickness);
    atField(entry, "", [&] {
        const auto model = context.files.model(json, file, false);
        if (thickness > 0.0f) {
            collider.grid = builder.addColliderGrid(makeSheetGrid(model->vertices, model->triangles, cell, thickness));
            return;
        }
        collider.grid = builder.addColliderGrid(makeDistanceGrid(model->vertices, model->triangles, cell));
        const float opening = widestOpening(model->vertices, model->triangles);
        if (opening > 2.0f * cell)
            context.warnings.push_back(fmt::format(
                "{}: the mesh is open, {:.3g} m wide, and counts as solid behind that; close it, or give it a "
                "`thickness` to be a thin wall",
                entry.pointer, opening));
    });
    collider.shape = ColliderShape::Mesh;
}

void addHeightfield(const SceneEntry& entry, Collider& collider)
{
    const Json& json = entry.json;
    Heights heights = readHeights(entry);
    if (heights.columns < 2 || heights.rows < 2 || heights.values.size() > MAX_GRID_VALUES)
        entry.fail("", fmt::format("has {} x {} heights; must be at least 2 x 2 and at most {} in all", heights.columns,
                                   heights.rows, MAX_GRID_VALUES));
    const Eigen::Vector2f size(json["size"][0].get<float>(), json["size"][1].get<float>());
    collider.grid = entry.context.builder.addColliderGrid(makeHeightfield(
        size, static_cast<int>(heights.columns), static_cast<int>(heights.rows), std::move(heights.values)));
    collider.shape = ColliderShape::Heightfield;
}

}  // namespace knuckle
