#include "app/export/layers/annotations.h"

#include <algorithm>
#include <array>

namespace knuckle {

namespace {

/// Pixels that show one thing.
struct Seen {
    uint32_t left = ~0u, top = ~0u, right = 0, bottom = 0;  ///< The first and last columns and rows.
    uint64_t count = 0;
    std::vector<size_t> ends = {};  ///< Where pixels begin and end to show it, column by column.

    void add(uint32_t column, uint32_t row, size_t place)
    {
        left = std::min(left, column);
        right = std::max(right, column);
        top = std::min(top, row);
        bottom = std::max(bottom, row);
        ++count;
        if (!ends.empty() && ends.back() == place) ++ends.back();
        else ends.insert(ends.end(), {place, place + 1});
    }
    Json box() const { return {left, top, right + 1 - left, bottom + 1 - top}; }
    /// Lengths of runs that do not show it and that do, in turn.
    Json counts(size_t pixels) const
    {
        Json runs = Json::array();
        size_t last = 0;
        for (const size_t end : ends) {
            runs.push_back(end - last);
            last = end;
        }
        if (last < pixels) runs.push_back(pixels - last);
        return runs;
    }
};

/// What is seen of each thing that a member of PixelIds names.
std::map<uint32_t, Seen> seenBy(const Layers& layers, const std::vector<PixelIds>& ids, uint32_t PixelIds::*which)
{
    std::map<uint32_t, Seen> seen;
    for (uint32_t column = 0; column < layers.width; ++column)
        for (uint32_t row = 0; row < layers.height; ++row)
            if (const uint32_t id = ids[size_t{row} * layers.width + column].*which; id != 0)
                seen[id].add(column, row, size_t{column} * layers.height + row);
    return seen;
}

/// "doll" of "doll_2": copies are of one kind.
std::string kindOf(const std::string& name)
{
    const size_t end = name.find_last_not_of("0123456789");
    return end != std::string::npos && end + 1 < name.size() && end > 0 && name[end] == '_' ? name.substr(0, end)
                                                                                            : name;
}

Json categoryOf(size_t id, const std::string& name, const Rig* rig)
{
    Json category{{"id", id}, {"name", name}, {"supercategory", rig != nullptr ? "figure" : "object"}};
    if (rig == nullptr) return category;
    const Figure2d figure = figureOf(rig->model);
    category["keypoints"] = figure.names;
    category["skeleton"] = Json::array();
    for (const auto& [parent, bone] : figure.edges) category["skeleton"].push_back({parent + 1, bone + 1});
    return category;
}

}  // namespace

Annotations::Annotations(const World& world, const SceneThings& things, const std::vector<Rig>& rigs)
    : world_(world), things_(things)
{
    for (const Rig& rig : rigs) rigs_[rig.object] = &rig;
    addCategories();
}

void Annotations::addCategories()
{
    for (uint32_t object = 0; object < things_.names().size(); ++object) {
        const auto rig = rigs_.find(object);
        Json category = knuckle::categoryOf(0, kindOf(things_.names()[object]),
                                            rig == rigs_.end() ? nullptr : rig->second);
        const auto same = std::ranges::find_if(categories_, [&](const Json& other) {
            category["id"] = other["id"];
            return other == category;
        });
        categoryOf_.push_back(static_cast<uint32_t>(same - categories_.begin()) + 1);
        category["id"] = categoryOf_.back();
        if (same == categories_.end()) categories_.push_back(category);
    }
}

void Annotations::addKeyPoints(Json& annotation, const Rig& rig, const Layers& layers, const std::vector<PixelIds>& ids,
                               const std::vector<BodyState>& bodies) const
{
    Json points = Json::array(), places = Json::array();
    size_t inside = 0;
    for (const KeyPoint& point : keyPointsOf(world_, rig, bodies, layers, ids)) {
        points.insert(points.end(), {point.column, point.row, point.visibility});
        for (const double value : point.place) places.push_back(value);
        if (point.visibility > 0) ++inside;
    }
    annotation["num_keypoints"] = inside;
    annotation["keypoints"] = points;
    annotation["keypoints_3d"] = places;
}

void Annotations::add(uint64_t frame, const std::string& file, const Layers& layers, const std::vector<PixelIds>& ids,
                      const std::vector<BodyState>& bodies)
{
    const size_t image = images_.size() + 1, pixels = ids.size();
    images_.push_back(
        {{"id", image}, {"file_name", file}, {"width", layers.width}, {"height", layers.height}, {"frame", frame}});
    const std::map<uint32_t, Seen> ofBodies = seenBy(layers, ids, &PixelIds::body);
    for (const auto& [id, seen] : seenBy(layers, ids, &PixelIds::object)) {
        Json annotation{{"id", annotations_.size() + 1},
                        {"image_id", image},
                        {"category_id", categoryOf_.at(id - 1)},
                        {"object_id", id},
                        {"bbox", seen.box()},
                        {"area", seen.count},
                        {"iscrowd", 0},
                        {"segmentation", {{"size", {layers.height, layers.width}}, {"counts", seen.counts(pixels)}}}};
        annotation["bodies"] = Json::array();
        for (const auto& [body, part] : ofBodies)
            if (world_.bodies[body - 1].object + 1 == id)
                annotation["bodies"].push_back({{"body_id", body},
                                                {"name", world_.bodies[body - 1].name},
                                                {"bbox", part.box()},
                                                {"area", part.count}});
        if (const auto rig = rigs_.find(id - 1); rig != rigs_.end() && id <= world_.objects.size())
            addKeyPoints(annotation, *rig->second, layers, ids, bodies);
        annotations_.push_back(annotation);
    }
}

Json Annotations::json() const
{
    return {{"info",
             {{"description", "Boxes and masks of what is seen, joints of figures; keypoints_3d in metres, +Y up"}}},
            {"images", images_},
            {"categories", categories_},
            {"annotations", annotations_}};
}

}  // namespace knuckle
