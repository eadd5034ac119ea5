#include "app/commands/voxelize/actor_preview.h"

#include <algorithm>
#include <array>
#include <span>

#include "render/renderer.h"
#include "render/view/framing.h"
#include "sim/rig/skin/skin_mesh.h"
#include "sim/solver/solver.h"

namespace knuckle {

namespace {

constexpr uint32_t VIEWS = 2, WIDTH = 1280 / VIEWS, HEIGHT = 720;
constexpr uint32_t SAMPLES = 2;        // per axis and pixel
constexpr float FIELD_OF_VIEW = 9.0f;  // so far away that front and side look like orthographic projections [degrees]
constexpr float SKIN_OPACITY = 0.45f;
constexpr float RISE = 0.07f;  // of the camera, so that the ground is visible

/// The actor on a ground plane, with its skin if the model has one.
World previewWorld(const Actor& actor, const Model& model)
{
    WorldBuilder builder(0.5f * actor.diameter);
    const uint32_t material = builder.addMaterial({});
    Collider ground;
    float lowest = actor.particles.front().y();
    for (const Vector3f& position : actor.particles) lowest = std::min(lowest, position.y());
    ground.position.y() = lowest - 0.5f * actor.diameter;
    builder.addCollider(ground);
    const std::array objects{addActor(builder, actor, material, {})};
    if (!model.surface.vertices.empty())
        builder.addSkin(std::make_shared<const SkinMesh>(makeSkinMesh(actor, model)), objects, SkinUse::Cover);
    return builder.build();
}

/// The visible points: particles, and the mesh beyond them.
std::vector<Vector3f> shownPoints(const Actor& actor, const Model& model)
{
    std::vector<Vector3f> points = actor.particles;
    points.insert(points.end(), model.vertices.begin(), model.vertices.end());
    return points;
}

RenderSettings viewFrom(const Vector3f& side, std::span<const Vector3f> points, float radius, bool legend)
{
    RenderSettings settings;
    settings.width = WIDTH;
    settings.height = HEIGHT;
    settings.antialiasing = SAMPLES;
    settings.highlightJoints = true;
    settings.markJoints = true;
    settings.legend = legend;
    settings.skinOpacity = SKIN_OPACITY;
    settings.light.direction = side + 0.55f * Vector3f::UnitY().cross(-side) + 1.1f * Vector3f::UnitY();
    settings.camera = cameraThatFrames({.points = points,
                                        .radius = radius,
                                        .back = (side + RISE * Vector3f::UnitY()).normalized(),
                                        .fieldOfView = FIELD_OF_VIEW,
                                        .aspect = float(WIDTH) / float(HEIGHT)});
    return settings;
}

/// Puts a picture next to others of its size.
void place(const Image& view, uint32_t index, Image& picture)
{
    const size_t row = 3 * size_t{view.width};
    for (size_t y = 0; y < view.height; ++y)
        std::copy_n(view.rgb.begin() + static_cast<ptrdiff_t>(y * row), row,
                    picture.rgb.begin() + static_cast<ptrdiff_t>((y * VIEWS + index) * row));
}

}  // namespace

Image drawPreview(const Actor& actor, const Figure& figure, const CommonOptions& common)
{
    const World world = previewWorld(actor, figure.model);
    const std::vector<Vector3f> points = shownPoints(actor, figure.model);
    const float radius = 0.5f * actor.diameter;
    const std::array sides{viewFrom(figure.forward, points, radius, true),
                           viewFrom(figure.left, points, radius, false)};
    const auto gpu = openGpu(common, FrameWork{{}, drawingWorkload(sides.front())});
    Solver solver(*gpu, world);
    Image picture{VIEWS * WIDTH, HEIGHT, std::vector<uint8_t>(size_t{3} * VIEWS * WIDTH * HEIGHT)};
    for (uint32_t v = 0; v < VIEWS; ++v) {
        Renderer renderer(*gpu, world, sides[v]);
        renderer.draw(solver.view(), 0.0);
        place(renderer.readImage(), v, picture);
    }
    return picture;
}

}  // namespace knuckle
