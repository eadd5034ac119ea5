#include "render/skins/skin_buffers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/color_word.h"
#include "render/looks/finishes.h"
#include "render/skins/skin_lods.h"
#include "render/skins/skin_looks.h"
#include "sim/base/errors.h"
#include "sim/gpu/filled_buffer.h"

namespace knuckle {

namespace {

/// Numbers of 0 ... 1 in the format of packUnorm2x16().
uint32_t packUnorm(float x, float y)
{
    const auto bits = [](float part) { return static_cast<uint32_t>(std::lround(65535.0f * part)); };
    return bits(x) | bits(y) << 16;
}

/// A number of -1 ... 1 in the format of packSnorm2x16().
uint32_t packSnorm(float x)
{
    return static_cast<uint32_t>(std::lround(32767.0f * std::clamp(x, -1.0f, 1.0f))) & 0xFFFFu;
}

bool isOneSided(const Skin& skin)
{
    return std::ranges::none_of(skin.mesh->materials, &SkinMaterial::twoSided);
}

gpu::vec4 texel(const Eigen::Vector3f& v, float w = 0.0f)
{
    return {v.x(), v.y(), v.z(), w};
}

/// The arrays before they are uploaded.
struct SkinArrays {
    explicit SkinArrays(const World& world) : finishes(world) {}
    void add(const Skin& skin, const World& world);

    Finishes finishes;
    std::vector<uint32_t> indices;
    std::vector<gpu::SkinVertex> vertices;
    std::vector<gpu::vec4> vertexLooks, centres;
    std::vector<gpu::SkinLod> lods;
    std::vector<gpu::SkinWearer> wearers;
    std::vector<gpu::uvec4> groups;
    SkinLooks looks;

private:
    void addVertex(const SkinVertex& vertex, const SkinMesh& mesh, uint32_t firstMaterial);
    /// Above the index of the material; 0 in worlds without finishes, whose shaders do not look for it.
    uint32_t finishOf(const SkinMaterial& material) const
    {
        const bool isMapped = material.roughnesses != NO_INDEX && finishes.mappedAlpha() != 0;
        return finishes.empty() ? 0
                                : (isMapped ? finishes.mappedAlpha() : finishes.alphaOf(modelFinish(material))) << 16;
    }
    void addWearer(const Object& object, const SkinMesh& mesh, gpu::SkinWearer wearer, uint32_t firstVertex,
                   uint32_t finish);
};

void SkinArrays::addVertex(const SkinVertex& vertex, const SkinMesh& mesh, uint32_t firstMaterial)
{
    const auto& b = vertex.bodies;
    const auto& w = vertex.weights;
    const Eigen::Vector3f &p = vertex.position, &n = vertex.normal;
    vertices.push_back({p.x(), p.y(), p.z(), packSnorm(n.x()) | packSnorm(n.y()) << 16, b[0] | b[1] << 16,
                        b[2] | b[3] << 16, packUnorm(w[1], w[2]), packUnorm(0.0f, w[3]) | packSnorm(n.z())});
    const Eigen::Vector3f color = vertex.color.cwiseProduct(mesh.materials[vertex.material].color);
    const uint32_t material = (firstMaterial + vertex.material) | finishOf(mesh.materials[vertex.material]);
    vertexLooks.push_back({vertex.uv.x(), vertex.uv.y(), static_cast<float>(packColor(color) & COLOR_BITS),
                           static_cast<float>(material)});
}

void SkinArrays::addWearer(const Object& object, const SkinMesh& mesh, gpu::SkinWearer wearer, uint32_t firstVertex,
                           uint32_t finish)
{
    wearer.firstBody = object.bodyStart;
    wearer.bodyCount = object.bodyCount;
    wearer.firstPlace = static_cast<uint32_t>(groups.size()) * SKIN_GROUP_SIZE;
    const auto index = static_cast<uint32_t>(wearers.size());
    wearers.push_back(wearer);
    const auto count = static_cast<uint32_t>(mesh.vertices.size());
    for (uint32_t i = 0; i < count; i += SKIN_GROUP_SIZE) groups.push_back({index, firstVertex + i, i, finish});
    for (const SkinVertex& vertex : mesh.vertices) {
        for (int k = 0; k < 4; ++k) {
            if (vertex.weights[k] <= 0.0f) continue;
            gpu::vec4& centre = centres[object.bodyStart + vertex.bodies[k]];
            centre.w = std::max(centre.w, (vertex.position - Eigen::Vector3f(centre.x, centre.y, centre.z)).norm());
        }
    }
}

void SkinArrays::add(const Skin& skin, const World& world)
{
    const SkinMesh& mesh = *skin.mesh;
    const SkinLods detail = makeSkinLods(mesh);
    const auto firstIndex = static_cast<uint32_t>(indices.size()), firstVertex = static_cast<uint32_t>(vertices.size());
    gpu::SkinWearer wearer{};
    wearer.firstLod = static_cast<uint32_t>(lods.size());
    wearer.lodCount = static_cast<uint32_t>(detail.levels.size());
    for (const SkinLod& lod : detail.levels)
        lods.push_back({firstIndex + lod.firstIndex, lod.indexCount, lod.vertexCount, lod.error});
    indices.insert(indices.end(), detail.indices.begin(), detail.indices.end());
    const uint32_t firstMaterial = looks.add(mesh);
    for (const uint32_t vertex : detail.vertices) addVertex(mesh.vertices[vertex], mesh, firstMaterial);
    for (const uint32_t object : skin.objects) {
        const SurfaceFinish& finish = world.materials[world.bodies[world.objects[object].bodyStart].material].finish;
        addWearer(world.objects[object], mesh, wearer, firstVertex,
                  finish.word == Finish::Model ? 0 : finishes.alphaOf(finish));
    }
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

SkinBuffers::SkinBuffers(const Gpu& gpu, const World& world)
{
    SkinArrays arrays(world);
    for (const Body& body : world.bodies) arrays.centres.push_back(texel(body.restCentre, -1.0f));
    for (const bool oneSided : {true, false}) {
        for (const Skin& skin : world.skins)
            if (isDrawn(skin) && isOneSided(skin) == oneSided) arrays.add(skin, world);
        if (oneSided) oneSidedCount = static_cast<uint32_t>(arrays.wearers.size());
    }
    wearerCount = static_cast<uint32_t>(arrays.wearers.size());
    groupCount = static_cast<uint32_t>(arrays.groups.size());
    requireRoom(gpu, "vertices", size_t{groupCount} * SKIN_GROUP_SIZE);
    requireRoom(gpu, "textures", arrays.looks.texels.size());
    indices = filledBuffer("skinIndices", arrays.indices);
    vertices = filledBuffer("skinVertices", arrays.vertices);
    vertexLooks = filledBuffer("skinVertexLooks", arrays.vertexLooks);
    lods = filledBuffer("skinLods", arrays.lods);
    wearers = filledBuffer("skinWearers", arrays.wearers);
    groups = filledBuffer("skinGroups", arrays.groups);
    centres = filledBuffer("skinCentres", arrays.centres);
    materials = filledBuffer("skinMaterials", arrays.looks.materials);
    levels = filledBuffer("skinLevels", arrays.looks.levels);
    texels = filledBuffer("skinTexels", arrays.looks.texels);
    draws = {"skinDraws", size_t{2} * wearerCount};
    placeCounts = {"skinPlaceCounts", wearerCount};
    places = {"skinPlaces", size_t{groupCount} * SKIN_GROUP_SIZE};
}

void SkinBuffers::addTo(BufferTable& table)
{
    table.add(Lifetime::Constant, vertices, vertexLooks, lods, wearers, groups, centres, materials, levels, texels);
    table.add(Lifetime::Scratch, draws, placeCounts, places);
}

}  // namespace knuckle
