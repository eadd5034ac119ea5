#include "sim/rig/mesh/polyhedron.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr size_t MOST_FACETS = 24;  // what has more is round
constexpr float SAME = 1e-3f;       // of the size: places and planes that are one
constexpr float SLACK = 0.1f;       // d: by how much particles may be further apart than a diameter
constexpr float ROOM = 0.6f;        // d: particles of one body are not nearer

/// A corner, and which facets meet there.
struct Corner {
    Vector3f place;
    uint32_t facets;
};

/// Corners where three facets meet, those behind which all others are.
std::vector<Corner> cornersOf(const std::vector<Facet>& facets, float same)
{
    std::vector<Corner> corners;
    const auto add = [&](const Vector3f& place, uint32_t mask) {
        for (const Facet& f : facets)
            if (f.normal.dot(place) > f.distance + same) return;
        for (Corner& corner : corners) {
            if ((corner.place - place).norm() > 2.0f * same) continue;
            corner.facets |= mask;
            return;
        }
        corners.push_back({place, mask});
    };
    for (size_t i = 0; i < facets.size(); ++i) {
        for (size_t j = i + 1; j < facets.size(); ++j) {
            for (size_t k = j + 1; k < facets.size(); ++k) {
                Eigen::Matrix3d normals;
                for (int row = 0; const size_t f : {i, j, k}) normals.row(row++) = facets[f].normal.cast<double>();
                if (std::abs(normals.determinant()) < 1e-3) continue;
                const Eigen::Vector3d distances(facets[i].distance, facets[j].distance, facets[k].distance);
                add((normals.inverse() * distances).cast<float>(), 1u << i | 1u << j | 1u << k);
            }
        }
    }
    return corners;
}

/// Parts of a length, each about a diameter long.
int partsOf(float length, float diameter)
{
    return std::max(1, static_cast<int>(std::ceil(length / diameter - SLACK)));
}

/// Calls visit(place) for places evenly between two others, without these.
template <typename Visit>
void forEachBetween(const Vector3f& a, const Vector3f& b, float diameter, Visit visit)
{
    const int parts = partsOf((b - a).norm(), diameter);
    for (int k = 1; k < parts; ++k) visit(Vector3f(a + (b - a) * (static_cast<float>(k) / static_cast<float>(parts))));
}

struct Edge {
    Vector3f a, b;
};

/// Fills a polyhedron whose facets are where its outermost particles are: corners, edges, facets, then its inside.
class Filling {
public:
    Filling(const std::vector<Facet>& facets, float diameter)
        : facets_(facets), diameter_(diameter), corners_(cornersOf(facets, SAME * diameter))
    {
    }

    std::vector<Vector3f> places()
    {
        if (corners_.size() < 4) return {};
        for (const Corner& corner : corners_) add(corner.place);
        for (const Edge& edge : edgesOf(~0u)) addBetween(edge.a, edge.b);
        for (size_t f = 0; f < facets_.size(); ++f) fillFacet(f);
        fillInside();
        return places_;
    }

private:
    void add(const Vector3f& place)
    {
        const auto isNear = [&](const Vector3f& p) { return (p - place).norm() < ROOM * diameter_; };
        if (std::ranges::none_of(places_, isNear)) places_.push_back(place);
    }
    void addBetween(const Vector3f& a, const Vector3f& b)
    {
        forEachBetween(a, b, diameter_, [&](const Vector3f& place) { add(place); });
    }

    /// Edges of one of these facets.
    std::vector<Edge> edgesOf(uint32_t facets) const
    {
        std::vector<Edge> edges;
        for (size_t i = 0; i < corners_.size(); ++i)
            for (size_t k = i + 1; k < corners_.size(); ++k) {
                const uint32_t common = corners_[i].facets & corners_[k].facets;
                if (std::popcount(common) >= 2 && (common & facets) != 0u)
                    edges.push_back({corners_[i].place, corners_[k].place});
            }
        return edges;
    }

    /// In rows along the longest edge, each evenly from side to side.
    void fillFacet(size_t facet)
    {
        const std::vector<Edge> edges = edgesOf(1u << facet);
        if (edges.size() < 3) return;
        const Edge& longest = *std::ranges::max_element(edges, {}, [](const Edge& e) { return (e.b - e.a).norm(); });
        const Vector3f along = (longest.b - longest.a).normalized(), across = facets_[facet].normal.cross(along);
        const auto height = [&](const Vector3f& p) { return across.dot(p); };
        float low = height(edges.front().a), high = low;
        for (const Edge& edge : edges) {
            low = std::min({low, height(edge.a), height(edge.b)});
            high = std::max({high, height(edge.a), height(edge.b)});
        }
        const int rows = partsOf(high - low, diameter_);
        for (int row = 1; row < rows; ++row) {
            const float at = low + (high - low) * static_cast<float>(row) / static_cast<float>(rows);
            std::vector<Vector3f> ends;
            for (const Edge& edge : edges) {
                const float a = height(edge.a), b = height(edge.b);
                if ((a < at) != (b < at)) ends.emplace_back(edge.a + (edge.b - edge.a) * ((at - a) / (b - a)));
            }
            if (ends.size() == 2) addBetween(ends[0], ends[1]);
        }
    }

    void fillInside()
    {
        const std::vector<Edge> edges = edgesOf(~0u);
        const Edge& longest = *std::ranges::max_element(edges, {}, [](const Edge& e) { return (e.b - e.a).norm(); });
        Eigen::Matrix3f axes;
        const Vector3f along = (longest.b - longest.a).normalized();
        axes << along, along.unitOrthogonal(), Vector3f::Zero();
        // A facet at the longest edge gives the second axis.
        for (const Facet& f : facets_)
            if (std::abs(f.normal.dot(along)) < SAME &&
                std::abs(f.normal.dot(longest.a) - f.distance) < SAME * diameter_)
                axes.col(1) = f.normal;
        axes.col(2) = along.cross(axes.col(1));
        Eigen::AlignedBox3f bounds;
        for (const Corner& corner : corners_) bounds.extend(axes.transpose() * corner.place);
        const Vector3f size = bounds.sizes();
        const Eigen::Vector3i parts(partsOf(size.x(), diameter_), partsOf(size.y(), diameter_),
                                    partsOf(size.z(), diameter_));
        for (int x = 1; x < parts.x(); ++x)
            for (int y = 1; y < parts.y(); ++y)
                for (int z = 1; z < parts.z(); ++z) {
                    const Vector3f part = Eigen::Vector3i(x, y, z).cast<float>().cwiseQuotient(parts.cast<float>());
                    const Vector3f place = axes * (bounds.min() + size.cwiseProduct(part));
                    const auto isBehind = [&](const Facet& f) { return f.normal.dot(place) < f.distance; };
                    if (std::ranges::all_of(facets_, isBehind)) add(place);
                }
    }

    const std::vector<Facet>& facets_;
    float diameter_;
    std::vector<Corner> corners_;
    std::vector<Vector3f> places_;
};

/// The planes of all triangles, each once.
std::vector<Facet> planesOf(const Solid& solid, const Vector3f& middle, float same)
{
    std::vector<Facet> planes;
    for (const Triangle& t : solid.triangles()) {
        const Vector3f a = solid.vertices()[t[0]], ab = solid.vertices()[t[1]] - a, ac = solid.vertices()[t[2]] - a;
        const Vector3f cross = ab.cross(ac);
        if (cross.norm() < same * same) continue;
        const Vector3f normal = cross.normalized() * (cross.dot(middle - a) > 0.0f ? -1.0f : 1.0f);
        const Facet facet{normal, normal.dot(a)};
        const auto isSame = [&](const Facet& f) {
            return (f.normal - normal).norm() < 0.01f && std::abs(f.normal.dot(a) - f.distance) < same;
        };
        if (std::ranges::none_of(planes, isSame)) planes.push_back(facet);
        if (planes.size() > MOST_FACETS) return {};
    }
    return planes;
}

}  // namespace

std::vector<Facet> facetsOf(const Solid& solid)
{
    Vector3f middle = Vector3f::Zero();
    for (const Triangle& t : solid.triangles())
        for (const uint32_t v : t) middle += solid.vertices()[v];
    middle /= 3.0f * static_cast<float>(solid.triangles().size());
    const float same = SAME * solid.bounds().sizes().maxCoeff();
    const std::vector<Facet> facets = planesOf(solid, middle, same);
    if (facets.size() < 4) return {};
    for (const Triangle& t : solid.triangles())
        for (const uint32_t v : t)
            for (const Facet& f : facets)
                if (f.normal.dot(solid.vertices()[v]) > f.distance + same) return {};
    // Of an open mesh some corner is missing.
    Eigen::AlignedBox3f bounds;
    for (const Corner& corner : cornersOf(facets, same)) bounds.extend(corner.place);
    const float off = std::max((bounds.min() - solid.bounds().min()).cwiseAbs().maxCoeff(),
                               (bounds.max() - solid.bounds().max()).cwiseAbs().maxCoeff());
    return !bounds.isEmpty() && off < 3.0f * same ? facets : std::vector<Facet>();
}

bool isBoxAlongAxes(const std::vector<Facet>& facets)
{
    return std::ranges::all_of(facets, [](const Facet& f) { return f.normal.cwiseAbs().maxCoeff() > 1.0f - 1e-6f; });
}

std::vector<Vector3f> fillPolyhedron(const std::vector<Facet>& facets, float diameter)
{
    std::vector<Facet> inner = facets;
    for (Facet& facet : inner) facet.distance -= 0.5f * diameter;
    return Filling(inner, diameter).places();
}

}  // namespace knuckle
