#include "render/skins/skin_lods.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace knuckle {

namespace {

/// Triangles of a level over those of the one before: the requested ratio, and the largest that is worth its memory.
constexpr double WANTED = 0.67, WORTHWHILE = 0.8;
/// Largest error of the coarsest level, in sizes of the mesh.
constexpr float LAST_ERROR = 0.1f;
/// The next level is simplified from a level with more triangles than this: that adds its error to the next one's, but
/// saves time. Otherwise the next one is simplified from the same level as the one before.
constexpr size_t MANY = 50'000;

/// How much the middle of a joint is inflated: as curved as a bend by half a right angle makes it.
constexpr float BULGE = 2.0f;
/// How far bodies are moved apart, in radii of their joints.
constexpr float APART = 0.3f;

/// Where the skin passes from one body to another.
struct Bend {
    float weight = 0.0f, squares = 0.0f;
    Eigen::Vector3f sum{0, 0, 0};

    void add(const Eigen::Vector3f& place, float share)
    {
        weight += share;
        sum += share * place;
        squares += share * place.squaredNorm();
    }
    Eigen::Vector3f middle() const { return sum / weight; }
    /// Mean distance from the middle [m].
    float radius() const { return std::sqrt(std::max(0.0f, squares / weight - middle().squaredNorm())); }
};

using Bends = std::map<std::pair<uint32_t, uint32_t>, Bend>;  // by both bodies, the first below the second

Bends findBends(const SkinMesh& mesh)
{
    Bends bends;
    for (const auto& triangle : mesh.triangles) {
        std::map<uint32_t, float> weights;
        Eigen::Vector3f sum(0, 0, 0);
        for (const uint32_t corner : triangle) {
            const SkinVertex& vertex = mesh.vertices[corner];
            sum += vertex.position;
            for (int i = 0; i < 4; ++i)
                if (vertex.weights[i] > 0.0f) weights[vertex.bodies[i]] += vertex.weights[i] / 3.0f;
        }
        for (const auto& [a, ofA] : weights)
            for (const auto& [b, ofB] : weights)
                if (a < b) bends[{a, b}].add(sum / 3.0f, ofA * ofB);
    }
    return bends;
}

/// The R2 sequence (Roberts 2018), which spreads any number of directions evenly.
Eigen::Vector3f directionOf(uint32_t index)
{
    const auto number = static_cast<float>(index + 1);
    const float height = 2.0f * std::fmod(0.75487767f * number, 1.0f) - 1.0f;
    const float angle = 6.2831853f * std::fmod(0.56984029f * number, 1.0f);
    const float across = std::sqrt(1.0f - height * height);
    return {across * std::cos(angle), height, across * std::sin(angle)};
}

/// Places of vertices for simplification. A limb that is straight at rest must keep the rings at which it bends: so
/// each body is moved in its own direction, by a part of the width of its joints, and joints are inflated.
std::vector<Eigen::Vector3f> placesBent(const SkinMesh& mesh)
{
    const Bends bends = findBends(mesh);
    std::map<uint32_t, float> radii;
    for (const auto& [pair, bend] : bends)
        for (const uint32_t body : {pair.first, pair.second}) radii[body] = std::max(radii[body], bend.radius());
    std::vector<Eigen::Vector3f> places;
    places.reserve(mesh.vertices.size());
    for (const SkinVertex& vertex : mesh.vertices) {
        Eigen::Vector3f place = vertex.position;
        for (int i = 0; i < 4; ++i) {
            if (vertex.weights[i] > 0.0f)
                place += APART * vertex.weights[i] * radii[vertex.bodies[i]] * directionOf(vertex.bodies[i]);
            for (int k = 0; k < 4; ++k) {
                const auto bend = bends.find({vertex.bodies[i], vertex.bodies[k]});
                if (bend == bends.end()) continue;
                place += BULGE * vertex.weights[i] * vertex.weights[k] * (vertex.position - bend->second.middle());
            }
        }
        places.push_back(place);
    }
    return places;
}

struct Level {
    std::vector<uint32_t> indices;  ///< Three a triangle.
    float error = 0.0f;             ///< [m]
};

/// @param size of the mesh [m].
Level simplify(const std::vector<Eigen::Vector3f>& places, const Level& from, size_t triangles, float size)
{
    Level level{std::vector<uint32_t>(from.indices.size())};
    float error = 0.0f;
    level.indices.resize(meshopt_simplify(level.indices.data(), from.indices.data(), from.indices.size(),
                                          places[0].data(), places.size(), sizeof(places[0]), 3 * triangles, LAST_ERROR,
                                          0, &error));
    level.error = from.error + error * size;
    return level;
}

std::vector<Level> makeLevels(const SkinMesh& mesh)
{
    std::vector<Level> levels(1);
    for (const auto& triangle : mesh.triangles)
        levels[0].indices.insert(levels[0].indices.end(), triangle.begin(), triangle.end());
    if (mesh.triangles.empty()) return levels;
    const auto places = placesBent(mesh);
    const float size = meshopt_simplifyScale(places[0].data(), places.size(), sizeof(places[0]));
    for (size_t base = 0;;) {
        const auto last = static_cast<double>(levels.back().indices.size());
        Level next = simplify(places, levels[base], static_cast<size_t>(WANTED * last / 3.0), size);
        if (next.indices.empty() || static_cast<double>(next.indices.size()) > WORTHWHILE * last) return levels;
        if (next.indices.size() > 3 * MANY) base = levels.size();
        levels.push_back(std::move(next));
    }
}

/// Per vertex, the number of levels down to the coarsest that uses it.
std::vector<uint32_t> levelsOfVertices(const std::vector<Level>& levels, size_t vertexCount)
{
    std::vector<uint32_t> uses(vertexCount, 0);
    for (uint32_t i = 0; i < levels.size(); ++i)
        for (const uint32_t vertex : levels[i].indices) uses[vertex] = i + 1;
    return uses;
}

SkinLods inOrder(const std::vector<Level>& levels, size_t vertexCount)
{
    const std::vector<uint32_t> uses = levelsOfVertices(levels, vertexCount);
    SkinLods result;
    result.vertices.resize(vertexCount);
    std::iota(result.vertices.begin(), result.vertices.end(), 0u);
    std::ranges::stable_sort(result.vertices, [&](uint32_t a, uint32_t b) { return uses[a] > uses[b]; });
    std::vector<uint32_t> placeOf(vertexCount);
    for (uint32_t i = 0; i < vertexCount; ++i) placeOf[result.vertices[i]] = i;
    for (uint32_t i = 0; i < levels.size(); ++i) {
        SkinLod lod{.error = levels[i].error,
                    .firstIndex = static_cast<uint32_t>(result.indices.size()),
                    .indexCount = static_cast<uint32_t>(levels[i].indices.size())};
        lod.vertexCount = static_cast<uint32_t>(std::ranges::count_if(uses, [&](uint32_t count) { return count > i; }));
        result.levels.push_back(lod);
        std::vector<uint32_t> placed;
        for (const uint32_t vertex : levels[i].indices) placed.push_back(placeOf[vertex]);
        meshopt_optimizeVertexCache(placed.data(), placed.data(), placed.size(), vertexCount);
        result.indices.insert(result.indices.end(), placed.begin(), placed.end());
    }
    return result;
}

}  // namespace

SkinLods makeSkinLods(const SkinMesh& mesh)
{
    return inOrder(makeLevels(mesh), mesh.vertices.size());
}

}  // namespace knuckle
