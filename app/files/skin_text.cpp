#include "app/files/skin_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numeric>

#include "app/json/fields.h"
#include "app/json/list_text.h"

namespace knuckle {

namespace {

constexpr float EXACT = 1e-3f;  // of the sum of weights

template <typename T>
std::string numbersText(const T& numbers)
{
    return fmt::format("[{}]", fmt::join(numbers, ", "));
}

std::string weightsText(const std::vector<BodyWeights>& all, const char* bodies, const char* weights)
{
    const auto bodiesOf = [](const BodyWeights& each) { return numbersText(each.bodies); };
    const auto weightsOf = [](const BodyWeights& each) { return numbersText(each.weights); };
    return listText(bodies, all, bodiesOf, "    ") + "," + listText(weights, all, weightsOf, "    ");
}

void requireCount(const std::string& path, const Json& skin, const char* list, size_t count, const char* of)
{
    if (skin[list].size() != count)
        failAt(path, fmt::format("/skin/{}", list),
               fmt::format("has {} entries for {} {}; give one each", skin[list].size(), count, of));
}

std::vector<BodyWeights> readWeights(const std::string& path, const Json& skin, const char* bodies, const char* weights,
                                     size_t bodyCount)
{
    std::vector<BodyWeights> all;
    for (size_t i = 0; i < skin[bodies].size(); ++i) {
        BodyWeights& each = all.emplace_back();
        readValue(skin[bodies][i], each.bodies);
        readValue(skin[weights][i], each.weights);
        for (const uint32_t body : each.bodies)
            if (body >= bodyCount)
                failAt(path, fmt::format("/skin/{}/{}", bodies, i),
                       fmt::format("{} is not one of the {} bodies", body, bodyCount));
        const float sum = std::accumulate(each.weights.begin(), each.weights.end(), 0.0f);
        if (std::abs(sum - 1.0f) > EXACT)
            failAt(path, fmt::format("/skin/{}/{}", weights, i), fmt::format("has the sum {}; must be 1", sum));
    }
    return all;
}

}  // namespace

std::string skinText(const ActorSkin& skin)
{
    const auto triangleText = [](const std::array<uint32_t, 3>& triangle) { return numbersText(triangle); };
    return fmt::format("\n  \"skin\": {{{},{},{},{}\n  }}", listText("vertices", skin.vertices, vectorText, "    "),
                       listText("triangles", skin.triangles, triangleText, "    "),
                       weightsText(skin.ofVertices, "bodies", "weights"),
                       weightsText(skin.ofParticles, "particleBodies", "particleWeights"));
}

ActorSkin readSkin(const std::string& path, const Json& root, const Actor& actor)
{
    ActorSkin read;
    if (!root.contains("skin")) return read;
    const Json& skin = root["skin"];
    const size_t vertices = skin["vertices"].size(), particles = skin["particleBodies"].size();
    requireCount(path, skin, "bodies", vertices, "vertices");
    requireCount(path, skin, "weights", vertices, "vertices");
    if (particles > 0) requireCount(path, skin, "particleBodies", actor.particles.size(), "particles");
    requireCount(path, skin, "particleWeights", particles, "particleBodies");
    for (const Json& vertex : skin["vertices"]) readValue(vertex, read.vertices.emplace_back());
    for (const Json& triangle : skin["triangles"]) {
        readValue(triangle, read.triangles.emplace_back());
        for (const uint32_t vertex : read.triangles.back())
            if (vertex >= vertices)
                failAt(path, fmt::format("/skin/triangles/{}", read.triangles.size() - 1),
                       fmt::format("{} is not one of the {} vertices", vertex, vertices));
    }
    read.ofVertices = readWeights(path, skin, "bodies", "weights", actor.bodies.size());
    read.ofParticles = readWeights(path, skin, "particleBodies", "particleWeights", actor.bodies.size());
    return read;
}

}  // namespace knuckle
