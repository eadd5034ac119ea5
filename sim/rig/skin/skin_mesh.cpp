#include "sim/rig/skin/skin_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

std::map<std::string, uint32_t> bodiesByName(const Actor& actor)
{
    std::map<std::string, uint32_t> bodies;
    for (uint32_t b = 0; b < actor.bodies.size(); ++b) {
        if (actor.bodies[b].isCross) continue;
        bodies[actor.bodies[b].name] = b;
        for (const std::string& bone : actor.bodies[b].mergedBones) bodies[bone] = b;
    }
    return bodies;
}

}  // namespace

std::vector<std::pair<uint32_t, float>> weightsByOwner(const SkinWeights& skin, std::span<const uint32_t> owners)
{
    std::map<uint32_t, float> sums;
    for (size_t i = 0; i < skin.bones.size(); ++i)
        if (skin.weights[i] > 0.0f) sums[owners[skin.bones[i]]] += skin.weights[i];
    std::vector<std::pair<uint32_t, float>> order(sums.begin(), sums.end());
    std::ranges::stable_sort(order, std::ranges::greater(), &std::pair<uint32_t, float>::second);
    return order;
}

BodyWeights heaviestOf(std::vector<std::pair<uint32_t, float>> order)
{
    BodyWeights heaviest;
    order.resize(std::min(order.size(), heaviest.bodies.size()));
    float sum = 0.0f;
    for (const auto& [body, weight] : order) sum += weight;
    if (!(sum > 0.0f)) return heaviest;
    for (size_t i = 0; i < order.size(); ++i) {
        heaviest.bodies[i] = order[i].first;
        heaviest.weights[i] = order[i].second / sum;
    }
    return heaviest;
}

std::vector<uint32_t> bodiesOfBones(const Actor& actor, const Model& model)
{
    const std::map<std::string, uint32_t> byName = bodiesByName(actor);
    const size_t count = model.bones.size();
    std::vector<uint32_t> bodies(count, NO_INDEX);
    for (size_t b = 0; b < count; ++b) {
        if (const auto found = byName.find(model.bones[b].name); found != byName.end()) bodies[b] = found->second;
        else if (model.bones[b].parent >= 0) bodies[b] = bodies[model.bones[b].parent];
    }
    const auto known = [](uint32_t body) { return body != NO_INDEX; };
    if (actor.bodies.size() > 1 && std::ranges::none_of(bodies, known))
        throw InputError(fmt::format("no body of the actor '{}' is a bone of the model '{}': make the actor anew of it "
                                     "with knuckle voxelize",
                                     actor.name, model.name));
    // The others hang on the first body.
    std::ranges::replace(bodies, NO_INDEX, 0u);
    return bodies;
}

SkinMesh makeSkinMesh(const Actor& actor, const Model& model)
{
    const ModelSurface& surface = model.surface;
    if (surface.vertices.size() != model.vertices.size() || model.triangles.empty())
        throw InputError(fmt::format("the model '{}' has no mesh to draw: give one that has", model.name));
    const std::vector<uint32_t> bodies = bodiesOfBones(actor, model);
    SkinMesh mesh{{}, model.triangles, surface.materials, surface.textures};
    for (size_t v = 0; v < model.vertices.size(); ++v) {
        const SurfaceVertex& looks = surface.vertices[v];
        SkinVertex vertex{model.vertices[v], looks.normal, looks.uv, looks.color, looks.material};
        if (!model.skin.empty() && actor.bodies.size() > 1) {
            const auto [moving, weights] = heaviestOf(weightsByOwner(model.skin[v], bodies));
            vertex.bodies = moving;
            vertex.weights = weights;
        }
        mesh.vertices.push_back(vertex);
    }
    return mesh;
}

}  // namespace knuckle
