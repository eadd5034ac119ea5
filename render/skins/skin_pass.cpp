#include "render/skins/skin_pass.h"

#include <algorithm>

#include "render/looks/finishes.h"
#include "render/looks/picture_defines.h"
#include "render/render_groups.h"
#include "shared/frame_types.h"

namespace knuckle {

namespace {

bool hasCutOuts(const Skin& skin)
{
    return std::ranges::any_of(skin.mesh->materials, [](const SkinMaterial& m) { return m.alphaCutoff > 0.0f; });
}

bool isTwoSided(const Skin& skin)
{
    return std::ranges::any_of(skin.mesh->materials, &SkinMaterial::twoSided);
}

bool hasNormals(const Skin& skin)
{
    const auto isMapped = [](const SkinMaterial& material) { return material.normals != NO_INDEX; };
    return std::ranges::any_of(skin.mesh->materials, isMapped);
}

/// Whether its pixels need materials: for pictures, for cut-outs, or if some of it is visible from one side only.
bool needsMaterials(const Skin& skin)
{
    const auto& materials = skin.mesh->materials;
    return !skin.mesh->textures.empty() || hasCutOuts(skin) ||
           std::ranges::adjacent_find(materials, std::ranges::not_equal_to(), &SkinMaterial::twoSided) !=
               materials.end();
}

}  // namespace

SkinPass::SkinPass(const Gpu& gpu, BufferTable& table, const World& world, const RenderTargets& targets)
{
    if (std::ranges::none_of(world.skins, isDrawn)) return;
    buffers_ = SkinBuffers(gpu, world);
    buffers_.addTo(table);
    lod_ = Kernel(gpu, table, "render/skins/skin_lod.comp");
    pose_ = Kernel(gpu, table, "render/skins/skin_pose.comp");
    std::vector<std::string> reads = {"skinPlaces",    "skinGroups", "skinVertexLooks",
                                      "skinMaterials", "skinLevels", "skinTexels"};
    if (targets.hasLayers()) {
        earlier_.add(table, buffers_.places);
        reads.insert(reads.end(), {"earlierSkinPlaces", "skinWearers", "skinVertices"});
    }
    Defines looks = Finishes(world).lightingDefines();
    if (std::ranges::any_of(world.skins, needsMaterials)) looks.push_back({"MATERIALS", "1"});
    if (std::ranges::any_of(world.skins, hasNormals)) looks.push_back({"NORMALS", "1"});
    if (const uint32_t alpha = Finishes(world).mappedAlpha(); alpha != 0)
        looks.push_back({"ROUGHNESSES", std::to_string(alpha) + "u"});
    if (std::ranges::any_of(world.skins, isTwoSided)) looks.push_back({"TWO_SIDED", "1"});
    skins_ = DrawPass(gpu, table, {"skins/skin", "skins/skin", joined({looks, targets.layerDefines(true)})}, reads,
                      targets.geometry);
    Defines lightView{{"LIGHT_VIEW", "1"}};
    if (std::ranges::any_of(world.skins, hasCutOuts)) lightView.push_back({"CUT_OUT", "1"});
    shadow_ = DrawPass(gpu, table, {"skins/skin", "skins/skin_shadow", lightView}, reads, targets.shadowMap);
}

void SkinPass::update(KernelTimer& timer)
{
    if (empty()) return;
    lod_.dispatch(timer, renderGroups(buffers_.wearerCount));
    pose_.dispatch(timer, buffers_.groupCount);
}

void SkinPass::drawShadow(KernelTimer& timer) const
{
    // Only faces turned away from the light cast shadows, so that lit faces do not shade themselves.
    draw(timer, shadow_, buffers_.wearerCount, GL_FRONT);
}

void SkinPass::draw(KernelTimer& timer) const
{
    draw(timer, skins_, 0, GL_BACK);
}

void SkinPass::draw(KernelTimer& timer, const DrawPass& pass, uint32_t first, GLenum culled) const
{
    const uint32_t oneSided = buffers_.oneSidedCount, others = buffers_.wearerCount - oneSided;
    pass.drawIndexed(timer, buffers_.indices, buffers_.draws, {first, oneSided, culled});
    pass.drawIndexed(timer, buffers_.indices, buffers_.draws, {first + oneSided, others});
}

}  // namespace knuckle
