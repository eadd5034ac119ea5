#include "sim/rig/skin/actor_skin.h"

#include <algorithm>
#include <map>

#include "sim/rig/mesh/triangle_tree.h"
#include "sim/rig/skin/skin_mesh.h"

namespace knuckle {

namespace {

/// The mean of the weights of a triangle's corners.
BodyWeights weightsAt(const ActorSkin& skin, const SurfacePoint& point)
{
    std::map<uint32_t, float> sums;
    for (int corner = 0; corner < 3; ++corner) {
        const uint32_t vertex = skin.triangles[point.triangle][static_cast<size_t>(corner)];
        const auto& [bodies, weights] = skin.ofVertices[vertex];
        for (size_t i = 0; i < bodies.size(); ++i) sums[bodies[i]] += point.barycentric[corner] * weights[i];
    }
    std::erase_if(sums, [](const auto& sum) { return sum.second <= 0.0f; });
    std::vector<std::pair<uint32_t, float>> order(sums.begin(), sums.end());
    std::ranges::stable_sort(order, std::ranges::greater(), &std::pair<uint32_t, float>::second);
    return heaviestOf(std::move(order));
}

}  // namespace

ActorSkin makeActorSkin(const Actor& actor, const Model& model)
{
    ActorSkin skin;
    if (model.triangles.empty()) return skin;
    skin.vertices = model.vertices;
    skin.triangles = model.triangles;
    skin.ofVertices.resize(model.vertices.size());
    if (!model.skin.empty() && actor.bodies.size() > 1) {
        const std::vector<uint32_t> bodies = bodiesOfBones(actor, model);
        for (size_t v = 0; v < model.vertices.size(); ++v)
            skin.ofVertices[v] = heaviestOf(weightsByOwner(model.skin[v], bodies));
    }
    const TriangleTree tree(model.vertices, model.triangles);
    for (const Vector3f& place : actor.particles)
        skin.ofParticles.push_back(weightsAt(skin, tree.nearestAround(place)));
    return skin;
}

}  // namespace knuckle
