#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "app/export/layers/key_points.h"
#include "app/json/json.h"
#include "render/layers/scene_things.h"

namespace knuckle {

/// Annotations of a film's frames in the keys of COCO: boxes, masks and numbers of pixels of objects and bodies that
/// are seen, and joints of figures.
class Annotations {
public:
    /// @param rigs of the scene's figures. All must outlive it.
    Annotations(const World& world, const SceneThings& things, const std::vector<Rig>& rigs);

    /// @param file of the frame. @param ids of its pixels.
    void add(uint64_t frame, const std::string& file, const Layers& layers, const std::vector<PixelIds>& ids,
             const std::vector<BodyState>& bodies);
    Json json() const;

private:
    void addCategories();
    void addKeyPoints(Json& annotation, const Rig& rig, const Layers& layers, const std::vector<PixelIds>& ids,
                      const std::vector<BodyState>& bodies) const;

    const World& world_;
    const SceneThings& things_;
    std::map<uint32_t, const Rig*> rigs_;  ///< By object.
    std::vector<uint32_t> categoryOf_;     ///< Of each object.
    Json categories_ = Json::array(), images_ = Json::array(), annotations_ = Json::array();
};

}  // namespace knuckle
