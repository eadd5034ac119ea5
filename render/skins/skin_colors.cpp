#include "render/skins/skin_colors.h"

#include <algorithm>
#include <array>
#include <map>

#include "render/color_word.h"

namespace knuckle {

namespace {

/// Pictures are read at a level of at most this many pixels a side, whose pixels are about as large as particles.
constexpr uint32_t COARSE_SIDE = 128;

struct PaintedVertex {
    Vector3f position;
    uint32_t word;
};

TexturePicture coarse(TexturePicture picture)
{
    while (std::max(picture.width, picture.height) > COARSE_SIDE) picture = halved(picture);
    return picture;
}

Vector3f colorAt(const TexturePicture& picture, const Eigen::Vector2f& uv, const std::array<TextureWrap, 2>& wrap)
{
    const auto pixel = [](float part, uint32_t count) {
        return std::min(static_cast<uint32_t>(part * static_cast<float>(count)), count - 1);
    };
    const uint32_t column = pixel(wrapped(uv.x(), wrap[0]), picture.width);
    const uint32_t row = pixel(wrapped(uv.y(), wrap[1]), picture.height);
    const size_t index = size_t{row} * picture.width + column;
    return unpackColor(packPixel(&picture.rgba[4 * index]));
}

/// Vertices by the body with the largest weight, within the object.
std::map<uint32_t, std::vector<PaintedVertex>> verticesOf(const SkinMesh& mesh)
{
    std::vector<TexturePicture> pictures;
    for (const TexturePicture& picture : mesh.textures) pictures.push_back(coarse(picture));
    std::map<uint32_t, std::vector<PaintedVertex>> vertices;
    for (const SkinVertex& vertex : mesh.vertices) {
        const SkinMaterial& material = mesh.materials[vertex.material];
        Vector3f color = vertex.color.cwiseProduct(material.color);
        if (material.texture != NO_INDEX)
            color = color.cwiseProduct(colorAt(pictures[material.texture], vertex.uv, material.wrap));
        const auto heaviest = std::ranges::max_element(vertex.weights) - vertex.weights.begin();
        vertices[vertex.bodies[static_cast<size_t>(heaviest)]].push_back({vertex.position, packColor(color)});
    }
    return vertices;
}

uint32_t nearestWord(const std::vector<PaintedVertex>& vertices, const Vector3f& place)
{
    const auto distance = [&](const PaintedVertex& vertex) { return (vertex.position - place).squaredNorm(); };
    return std::ranges::min_element(vertices, {}, distance)->word;
}

/// Paints a body's particles.
void paintBody(const World& world, const Body& body, const std::vector<PaintedVertex>& vertices,
               std::span<uint32_t> words)
{
    for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l)
        words[world.links[l].particle] = nearestWord(vertices, body.restCentre + world.links[l].restOffset);
}

/// Copies of an object have their links in the same order.
void paintLike(const World& world, const Body& painted, const Body& copy, std::span<uint32_t> words)
{
    for (uint32_t l = 0; l < copy.linkCount; ++l)
        words[world.links[copy.linkStart + l].particle] = words[world.links[painted.linkStart + l].particle];
}

}  // namespace

void paintParticles(const World& world, std::span<uint32_t> words)
{
    for (const Skin& skin : world.skins) {
        if (skin.use != SkinUse::Paint || skin.objects.empty()) continue;
        const uint32_t first = world.objects[skin.objects[0]].bodyStart;
        for (const auto& [body, vertices] : verticesOf(*skin.mesh))
            for (const uint32_t object : skin.objects) {
                const Body& painted = world.bodies[first + body];
                const Body& other = world.bodies[world.objects[object].bodyStart + body];
                if (&other == &painted) paintBody(world, painted, vertices, words);
                else paintLike(world, painted, other, words);
            }
    }
}

}  // namespace knuckle
