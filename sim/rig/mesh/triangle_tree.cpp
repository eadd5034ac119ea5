#include "sim/rig/mesh/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace knuckle {

using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

constexpr uint32_t LEAF_SIZE = 6;
// A cluster counts as one dipole beyond this multiple of its reach (Barill et al. 2018).
constexpr float FAR_FACTOR = 2.0f;
constexpr uint32_t STACK_DEPTH = 64;
constexpr float COINCIDENT = 1.0001f;  // ratio of distances of surfaces that coincide

float boxDistanceSquared(const Vector3f& low, const Vector3f& high, const Vector3f& point)
{
    return (low - point).cwiseMax(point - high).cwiseMax(0.0f).squaredNorm();
}

// The foot of the point's perpendicular on the edge from corner i to corner j, as weights of the three corners.
Vector3f onEdge(int i, int j, float alongNumerator, float alongDenominator)
{
    Vector3f weights = Vector3f::Zero();
    const float t = alongDenominator > 0.0f ? std::clamp(alongNumerator / alongDenominator, 0.0f, 1.0f) : 0.0f;
    weights[i] = 1.0f - t;
    weights[j] = t;
    return weights;
}

}  // namespace

double solidAngle(const std::array<Vector3f, 3>& corners, const Vector3f& point)
{
    const Vector3d a = (corners[0] - point).cast<double>();
    const Vector3d b = (corners[1] - point).cast<double>();
    const Vector3d c = (corners[2] - point).cast<double>();
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double numerator = a.dot(b.cross(c));
    const double denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    if (numerator == 0.0 && denominator <= 0.0) {
        return 0.0;  // the point is in the triangle: neither sign is right
    }
    return std::atan2(numerator, denominator) / (2.0 * std::numbers::pi);
}

Vector3f nearestInTriangle(const std::array<Vector3f, 3>& corners, const Vector3f& point)
{
    const Vector3f ab = corners[1] - corners[0], ac = corners[2] - corners[0];
    const Vector3f ap = point - corners[0], bp = point - corners[1], cp = point - corners[2];
    const float d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d1 <= 0.0f && d2 <= 0.0f) {
        return {1, 0, 0};
    }
    if (d3 >= 0.0f && d4 <= d3) {
        return {0, 1, 0};
    }
    if (d6 >= 0.0f && d5 <= d6) {
        return {0, 0, 1};
    }
    const float vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f) {
        return onEdge(0, 1, d1, d1 - d3);
    }
    if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f) {
        return onEdge(0, 2, d2, d2 - d6);
    }
    if (va <= 0.0f && d4 - d3 >= 0.0f && d5 - d6 >= 0.0f) {
        return onEdge(1, 2, d4 - d3, (d4 - d3) + (d5 - d6));
    }
    return Vector3f(va, vb, vc) / (va + vb + vc);
}

TriangleTree::TriangleTree(std::span<const Vector3f> vertices, std::span<const Triangle> triangles)
    : vertices_(vertices), triangles_(triangles), order_(triangles.size()), centroids_(triangles.size())
{
    std::iota(order_.begin(), order_.end(), 0u);
    for (uint32_t t = 0; t < triangles.size(); ++t) {
        const auto c = corners(t);
        centroids_[t] = (c[0] + c[1] + c[2]) / 3.0f;
    }
    if (!triangles.empty()) {
        nodes_.reserve(2 * triangles.size() / LEAF_SIZE + 2);
        build(0, static_cast<uint32_t>(triangles.size()));
    }
}

std::array<Vector3f, 3> TriangleTree::corners(uint32_t triangle) const
{
    const Triangle& t = triangles_[triangle];
    return {vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]};
}

void TriangleTree::summarize(Node& node, uint32_t first, uint32_t count) const
{
    node.low.setConstant(std::numeric_limits<float>::max());
    node.high = -node.low;
    Vector3d moment = Vector3d::Zero(), areaNormal = Vector3d::Zero();
    double area = 0.0;
    for (uint32_t i = first; i < first + count; ++i) {
        const auto c = corners(order_[i]);
        const Vector3d normal = 0.5 * (c[1] - c[0]).cast<double>().cross((c[2] - c[0]).cast<double>());
        areaNormal += normal;
        area += normal.norm();
        moment += normal.norm() * centroids_[order_[i]].cast<double>();
        for (const Vector3f& corner : c) {
            node.low = node.low.cwiseMin(corner);
            node.high = node.high.cwiseMax(corner);
        }
    }
    node.areaNormal = areaNormal.cast<float>();
    node.centre = area > 0.0 ? Vector3f((moment / area).cast<float>()) : Vector3f(0.5f * (node.low + node.high));
    for (uint32_t i = first; i < first + count; ++i) {
        for (const Vector3f& corner : corners(order_[i])) {
            node.reach = std::max(node.reach, (corner - node.centre).norm());
        }
    }
}

// Median split on the longest side, so that the depth is log2 of the count for any mesh.
uint32_t TriangleTree::build(uint32_t first, uint32_t count)
{
    const uint32_t index = static_cast<uint32_t>(nodes_.size());
    nodes_.emplace_back();
    summarize(nodes_[index], first, count);
    if (count <= LEAF_SIZE) {
        nodes_[index].first = first;
        nodes_[index].count = count;
        return index;
    }
    Eigen::Index axis = 0;
    (nodes_[index].high - nodes_[index].low).maxCoeff(&axis);
    const auto begin = order_.begin() + first;
    const uint32_t half = count / 2;
    std::nth_element(begin, begin + half, begin + count, [&](uint32_t a, uint32_t b) {
        return centroids_[a][axis] != centroids_[b][axis] ? centroids_[a][axis] < centroids_[b][axis] : a < b;
    });
    build(first, half);
    const uint32_t right = build(first + half, count - half);
    nodes_[index].right = right;
    return index;
}

double TriangleTree::windingNumber(const Vector3f& point) const
{
    double sum = 0.0;
    std::array<uint32_t, STACK_DEPTH> stack;
    uint32_t size = 0;
    if (!nodes_.empty()) {
        stack[size++] = 0;
    }
    while (size > 0) {
        const uint32_t index = stack[--size];
        const Node& node = nodes_[index];
        const Vector3f away = node.centre - point;
        const float distance = away.norm();
        if (distance > FAR_FACTOR * node.reach) {
            const double d = distance;
            sum += static_cast<double>(node.areaNormal.dot(away)) / (4.0 * std::numbers::pi * d * d * d);
        } else if (node.count > 0) {
            for (uint32_t i = node.first; i < node.first + node.count; ++i) {
                sum += solidAngle(corners(order_[i]), point);
            }
        } else {
            stack[size++] = node.right;
            stack[size++] = index + 1;
        }
    }
    return sum;
}

bool TriangleTree::inside(const Vector3f& point) const
{
    return std::abs(windingNumber(point)) > 0.5;
}

template <typename Accept>
SurfacePoint TriangleTree::search(const Vector3f& point, float reach, Accept accept) const
{
    SurfacePoint best;
    float bestSquared = reach * reach;
    std::array<uint32_t, STACK_DEPTH> stack;
    uint32_t size = 0;
    stack[size++] = 0;
    while (size > 0) {
        const uint32_t index = stack[--size];
        const Node& node = nodes_[index];
        if (boxDistanceSquared(node.low, node.high, point) >= bestSquared) {
            continue;
        }
        for (uint32_t i = node.first; i < node.first + node.count; ++i) {
            const auto c = corners(order_[i]);
            if (!accept(c)) continue;
            const Vector3f weights = nearestInTriangle(c, point);
            const Vector3f position = weights[0] * c[0] + weights[1] * c[1] + weights[2] * c[2];
            const float squared = (position - point).squaredNorm();
            if (squared < bestSquared) {
                bestSquared = squared;
                best = {order_[i], weights, position, 0.0f};
            }
        }
        if (node.count == 0) {
            const Node& left = nodes_[index + 1];
            const Node& right = nodes_[node.right];
            const bool leftFirst = boxDistanceSquared(left.low, left.high, point) <=
                                   boxDistanceSquared(right.low, right.high, point);
            stack[size++] = leftFirst ? node.right : index + 1;
            stack[size++] = leftFirst ? index + 1 : node.right;
        }
    }
    best.distance = std::sqrt(bestSquared);
    return best;
}

SurfacePoint TriangleTree::nearest(const Vector3f& point) const
{
    return search(point, std::numeric_limits<float>::infinity(), [](const auto&) { return true; });
}

SurfacePoint TriangleTree::nearestAround(const Vector3f& point) const
{
    SurfacePoint first = nearest(point);
    const double winding = windingNumber(point);
    if (std::abs(winding) <= 0.5) return first;
    const auto behind = [&](const std::array<Vector3f, 3>& c) {
        return winding * static_cast<double>((c[1] - c[0]).cross(c[2] - c[0]).dot(point - c[0])) < 0.0;
    };
    if (behind(corners(first.triangle))) return first;
    const SurfacePoint around = search(point, first.distance * COINCIDENT, behind);
    return around.triangle == NO_INDEX ? first : around;
}

}  // namespace knuckle
