#include "tools/shapes/figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "sim/base/colors.h"

namespace knuckle {

using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

constexpr int HALVINGS = 8;
constexpr double NEAREST_CUT = 0.05;  // distance from a corner, in lengths of the edge: thinner triangles have no
                                      // direction
constexpr float GRAIN = 1e-3f;        // of normals and colours

class Cutter {
public:
    Cutter(const TriangleMesh& mesh, const Figure& figure) : mesh_(mesh), figure_(figure), points_(mesh.vertices)
    {
        for (const Vector3f& vertex : mesh.vertices) regions_.push_back(figure.regionAt(vertex.cast<double>()));
    }

    RegionMesh cut()
    {
        for (const Triangle& t : mesh_.triangles) {
            const std::array<Region, 3> r{regions_[t[0]], regions_[t[1]], regions_[t[2]]};
            if (r[0] == r[1] && r[1] == r[2]) add({t[0], t[1], t[2]}, r[0]);
            else if (r[1] == r[2]) cutOff(t[0], t[1], t[2]);
            else if (r[2] == r[0]) cutOff(t[1], t[2], t[0]);
            else if (r[0] == r[1]) cutOff(t[2], t[0], t[1]);
            else cutInThree(t);
        }
        return std::move(result_);
    }

private:
    // The point of the surface between two corners where the region changes.
    uint32_t border(uint32_t a, uint32_t b)
    {
        if (a > b) std::swap(a, b);
        const auto [place, isNew] = borders_.try_emplace({a, b}, static_cast<uint32_t>(points_.size()));
        if (!isNew) return place->second;
        const Vector3d from = points_[a].cast<double>(), way = points_[b].cast<double>() - from;
        double low = 0.0, high = 1.0;
        for (int i = 0; i < HALVINGS; ++i) {
            const double middle = 0.5 * (low + high);
            (figure_.regionAt(from + middle * way) == regions_[a] ? low : high) = middle;
        }
        const double at = std::clamp(low, NEAREST_CUT, 1.0 - NEAREST_CUT);
        points_.push_back(onSurface(figure_.distance, from + at * way).cast<float>());
        return place->second;
    }

    void cutOff(uint32_t tip, uint32_t b, uint32_t c)
    {
        const uint32_t ab = border(tip, b), ca = border(c, tip);
        add({tip, ab, ca}, regions_[tip]);
        add({ab, b, c}, regions_[b]);
        add({ab, c, ca}, regions_[b]);
    }

    void cutInThree(const Triangle& t)
    {
        const Vector3d centre = (points_[t[0]] + points_[t[1]] + points_[t[2]]).cast<double>() / 3.0;
        const uint32_t middle = static_cast<uint32_t>(points_.size());
        points_.push_back(onSurface(figure_.distance, centre).cast<float>());
        for (size_t i = 0; i < 3; ++i) {
            const uint32_t next = border(t[i], t[(i + 1) % 3]), last = border(t[(i + 2) % 3], t[i]);
            add({t[i], next, middle}, regions_[t[i]]);
            add({t[i], middle, last}, regions_[t[i]]);
        }
    }

    void add(const Triangle& points, Region region)
    {
        Triangle triangle{};
        for (size_t i = 0; i < 3; ++i) {
            const auto [place, isNew] = vertices_.try_emplace({points[i], region},
                                                              static_cast<uint32_t>(result_.mesh.vertices.size()));
            if (isNew) {
                result_.mesh.vertices.push_back(points_[points[i]]);
                result_.regions.push_back(region);
            }
            triangle[i] = place->second;
        }
        result_.mesh.triangles.push_back(triangle);
    }

    const TriangleMesh& mesh_;
    const Figure& figure_;
    std::vector<Vector3f> points_;
    std::vector<Region> regions_;  // per corner of the whole mesh
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> borders_;
    std::map<std::pair<uint32_t, Region>, uint32_t> vertices_;
    RegionMesh result_;
};

Vector3f rounded(const Vector3f& v)
{
    return (v / GRAIN).array().round() * GRAIN;
}

/// Adds the mesh of a figure.
void dress(Model& model, const Figure& figure)
{
    const RegionMesh cut = cutAtBorders(surfaceNets(figure.distance, figure.grid), figure);
    for (size_t v = 0; v < cut.regions.size(); ++v) {
        const Vector3d place = cut.mesh.vertices[v].cast<double>();
        SurfaceVertex looks;
        const Vector3d normal = gradient(figure.distance, place, 0.5 * figure.grid.finest).normalized();
        looks.normal = rounded(normal.cast<float>());
        looks.color = rounded(figure.colorAt(cut.regions[v], place));
        model.surface.vertices.push_back(looks);
        model.skin.push_back(figure.weightsAt(cut.regions[v], place));
    }
    const auto first = static_cast<uint32_t>(model.vertices.size());
    model.vertices.insert(model.vertices.end(), cut.mesh.vertices.begin(), cut.mesh.vertices.end());
    for (const Triangle& t : cut.mesh.triangles) model.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

}  // namespace

RegionMesh cutAtBorders(const TriangleMesh& mesh, const Figure& figure)
{
    return Cutter(mesh, figure).cut();
}

Model makeModel(const std::string& name, const Skeleton& skeleton, std::span<const Figure> figures)
{
    Model model;
    model.name = name;
    model.bones = bonesOf(skeleton);
    for (const Figure& figure : figures) dress(model, figure);
    SkinMaterial material;
    material.name = name;
    material.color = {1, 1, 1};
    material.twoSided = false;
    model.surface.materials = {material};
    return model;
}

Vector3f screenColor(int red, int green, int blue)
{
    const auto linear = [](int c) { return static_cast<float>(linearOfSrgb(c / 255.0)); };
    return {linear(red), linear(green), linear(blue)};
}

}  // namespace knuckle
