#include "app/export/layers/layer_film.h"

#include <limits>
#include <utility>

#include "render/output/exr_file.h"
#include "render/view/framed_sets.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

constexpr const char* AXES = "camera axes: x right, y up, looking along -z; world: +Y up, right-handed; metres. A "
                             "place (x, y, z) of the camera is at column cx + fx x / -z and row cy - fy y / -z, from "
                             "the upper left corner, where pixels' middles are at halves";

std::string exrOf(const Layers& layers, const std::vector<PixelIds>& ids, const std::vector<Eigen::Vector2f>& motions)
{
    std::vector<float> depths;
    depths.reserve(layers.places.size());
    for (const gpu::vec4& place : layers.places)
        depths.push_back(place.w < 0.0f ? std::numeric_limits<float>::infinity() : place.w);
    const gpu::vec4 &place = layers.places.front(), &albedo = layers.albedo.front();
    const PixelIds& id = ids.front();
    constexpr size_t WIDE = sizeof(gpu::vec4), IDS = sizeof(PixelIds);
    return knuckle::exrOf(layers.width, layers.height,
                          {{"albedo.R", &albedo.x, WIDE},
                           {"albedo.G", &albedo.y, WIDE},
                           {"albedo.B", &albedo.z, WIDE},
                           {"depth.Z", depths.data()},
                           {"id.body", &id.body, IDS},
                           {"id.collider", &id.collider, IDS},
                           {"id.material", &id.material, IDS},
                           {"id.object", &id.object, IDS},
                           {"id.particle", &id.particle, IDS},
                           {"motion.X", motions.front().data(), sizeof(Eigen::Vector2f)},
                           {"motion.Y", motions.front().data() + 1, sizeof(Eigen::Vector2f)},
                           {"normal.X", &place.x, WIDE},
                           {"normal.Y", &place.y, WIDE},
                           {"normal.Z", &place.z, WIDE}});
}

template <typename T>
Json namesOf(const std::vector<T>& things)
{
    Json names = Json::array();
    for (const T& thing : things) names.push_back(thing.name);
    return names;
}

}  // namespace

LayerFilm::LayerFilm(Gpu& gpu, const Scene& scene, const FilmView& view, LayerFiles files, const SceneThings& things,
                     const std::vector<Rig>& rigs)
    : scene_(scene), things_(things), shots_(shotsOf(view.picture)), files_(std::move(files)),
      renderer_(gpu, scene.world, view.picture), annotations_(scene.world, things, rigs)
{
}

size_t LayerFilm::shotOf(uint64_t frame) const
{
    return shotAt(shots_, scene_.timeOf(frame));
}

bool LayerFilm::goesOn(uint64_t frame) const
{
    return before_ && shotOf(frame) == shotOf(frame - 1);
}

void LayerFilm::pass(const ExportFrame& frame, const ParticleView& drawn)
{
    before_ = {*frame.view, renderer_.look(drawn, scene_.timeOf(frame.number))};
}

void LayerFilm::frame(const ExportFrame& frame, const ParticleView& drawn)
{
    const Layers layers = renderer_.draw(drawn, scene_.timeOf(frame.number));
    std::vector<PixelIds> ids;
    ids.reserve(layers.things.size());
    for (const gpu::uvec2& thing : layers.things) ids.push_back(things_.idsOf(thing));
    const std::vector<Eigen::Vector2f> motions = pixelMotions(scene_.world, layers, *frame.view,
                                                              goesOn(frame.number) ? &*before_ : nullptr);
    const std::string path = files_.frames().path(frame.number), file = path.substr(files_.folder.size() + 1);
    writeFile(path, exrOf(layers, ids, motions));
    addCamera(frame, layers, file);
    annotations_.add(frame.number, file, layers, ids, bodyStates(scene_.world, *frame.view));
    before_ = {*frame.view, layers.camera};
}

void LayerFilm::addCamera(const ExportFrame& frame, const Layers& layers, const std::string& file)
{
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row) {
        Json numbers = Json::array();
        for (int column = 0; column < 4; ++column) numbers.push_back(layers.camera.toWorld.matrix()(row, column));
        rows.push_back(numbers);
    }
    cameras_.push_back({{"frame", frame.number},
                        {"time", scene_.timeOf(frame.number)},
                        {"file", file},
                        {"width", layers.width},
                        {"height", layers.height},
                        {"fx", layers.camera.focal},
                        {"fy", layers.camera.focal},
                        {"cx", 0.5 * layers.width},
                        {"cy", 0.5 * layers.height},
                        {"camera_to_world", rows}});
}

void LayerFilm::finish()
{
    const Json camera{{"convention", AXES},
                      {"objects", things_.names()},
                      {"bodies", namesOf(scene_.world.bodies)},
                      {"materials", namesOf(scene_.world.materials)},
                      {"frames", cameras_}};
    writeFile(files_.camera(), camera.dump(1) + "\n");
    writeFile(files_.annotations(), annotations_.json().dump() + "\n");
}

}  // namespace knuckle
