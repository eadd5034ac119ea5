#include "render/skins/skin_pass.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/skins/skin_looks.h"
#include "shared/draw_types.h"
#include "sim/world/errors.h"

namespace knuckle {

namespace {

/// 8 bits a channel: a number that a float holds exactly.
float colorNumber(const Eigen::Vector3f& color)
{
    uint32_t word = 0;
    for (int i = 0; i < 3; ++i)
        word |= static_cast<uint32_t>(std::lround(255.0f * std::clamp(color[i], 0.0f, 1.0f))) << 8 * i;
    return static_cast<float>(word);
}

bool isOneSided(const SkinMesh& mesh)
{
    return std::ranges::none_of(mesh.materials, &SkinMaterial::twoSided);
}

void addVertices(std::vector<gpu::vec4>& out, const SkinMesh& mesh, uint32_t firstMaterial, uint32_t firstWearer)
{
    for (const SkinVertex& vertex : mesh.vertices) {
        const Eigen::Vector3f &p = vertex.position, &n = vertex.normal;
        const auto& b = vertex.bodies;
        const auto& w = vertex.weights;
        out.push_back({p.x(), p.y(), p.z(), static_cast<float>(firstMaterial + vertex.material)});
        out.push_back({n.x(), n.y(), n.z(), static_cast<float>(firstWearer)});
        out.push_back({vertex.uv.x(), vertex.uv.y(), colorNumber(vertex.color), 0.0f});
        out.push_back(
            {static_cast<float>(b[0]), static_cast<float>(b[1]), static_cast<float>(b[2]), static_cast<float>(b[3])});
        out.push_back({w[0], w[1], w[2], w[3]});
    }
}

bool hasCutOuts(const Skin& skin)
{
    return std::ranges::any_of(skin.mesh->materials, [](const SkinMaterial& m) { return m.alphaCutoff > 0.0f; });
}

void requireRoom(const Gpu& gpu, const char* what, size_t texels)
{
    const auto limit = static_cast<size_t>(gpu.limits().textureBufferSize);
    if (texels > limit)
        throw InputError(fmt::format("the {} of all skins take {} texels, the device allows {}: show fewer models with "
                                     "their skin, or simpler ones",
                                     what, texels, limit));
}

}  // namespace

SkinPass::SkinPass(const Gpu& gpu, BufferTable& table, const World& world, const RenderTargets& targets)
{
    if (world.skins.empty()) return;
    upload(gpu, world);
    table.add(Lifetime::Constant, vertices_, wearers_, centres_, materials_, levels_, texels_);
    skins_ = DrawPass(gpu, table, {"skins/skin", "skins/skin"},
                      {"frame", "view", "skinVertices", "skinWearers", "skinCentres", "bodyCentres", "bodyRotations",
                       "skinMaterials", "skinLevels", "skinTexels"},
                      targets.geometry);
    Defines lightView{{"LIGHT_VIEW", "1"}};
    if (std::ranges::any_of(world.skins, hasCutOuts)) lightView.push_back({"CUT_OUT", "1"});
    shadow_ = DrawPass(gpu, table, {"skins/skin", "skins/skin_shadow", lightView},
                       {"frame", "view", "skinVertices", "skinWearers", "skinCentres", "bodyCentres", "bodyRotations",
                        "skinMaterials", "skinLevels", "skinTexels"},
                       targets.shadowMap);
}

void SkinPass::upload(const Gpu& gpu, const World& world)
{
    std::vector<uint32_t> indices, wearers;
    std::vector<gpu::vec4> vertices, centres;
    SkinLooks looks;
    for (const Skin& skin : world.skins) {
        const auto firstVertex = static_cast<uint32_t>(vertices.size() / SKIN_VERTEX_TEXELS);
        draws_.push_back({static_cast<uint32_t>(indices.size()), static_cast<uint32_t>(3 * skin.mesh->triangles.size()),
                          firstVertex, static_cast<uint32_t>(skin.objects.size()), isOneSided(*skin.mesh)});
        addVertices(vertices, *skin.mesh, looks.add(*skin.mesh), static_cast<uint32_t>(wearers.size()));
        for (const auto& triangle : skin.mesh->triangles)
            indices.insert(indices.end(), triangle.begin(), triangle.end());
        for (const uint32_t object : skin.objects) wearers.push_back(world.objects[object].bodyStart);
    }
    for (const Body& body : world.bodies)
        centres.push_back({body.restCentre.x(), body.restCentre.y(), body.restCentre.z(), 0.0f});
    requireRoom(gpu, "vertices", vertices.size());
    requireRoom(gpu, "textures", looks.texels.size());
    indices_ = {"skinIndices", std::span<const uint32_t>(indices)};
    vertices_ = {"skinVertices", std::span<const gpu::vec4>(vertices)};
    wearers_ = {"skinWearers", std::span<const uint32_t>(wearers)};
    centres_ = {"skinCentres", std::span<const gpu::vec4>(centres)};
    materials_ = {"skinMaterials", std::span<const gpu::vec4>(looks.materials)};
    levels_ = {"skinLevels", std::span<const gpu::uvec4>(looks.levels)};
    texels_ = {"skinTexels", std::span<const uint32_t>(looks.texels)};
}

void SkinPass::draw(KernelTimer& timer, const DrawPass& pass) const
{
    for (IndexedDraw skin : draws_) {
        // Both sides of a surface cast shadows.
        skin.culled = skin.culled && &pass == &skins_;
        pass.drawIndexed(timer, indices_, skin);
    }
}

}  // namespace knuckle
