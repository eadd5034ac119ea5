#include "sim/rig/limbs/limb_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float SLENDER = 1.2f;     // length over thickness
constexpr float LENGTHWISE = 0.8f;  // cosine with a limb above which a direction does not lie across it

/// Sets where the limb ends, and whether anything hangs there.
void findEnd(const std::vector<BodyDraft>& drafts, uint32_t body, const Voxels& voxels,
             const std::optional<Vector3f>& boneEnd, LimbFrame& frame)
{
    const BodyDraft& draft = drafts[body];
    float farthest = 0.0f;
    for (const BodyDraft& other : drafts) {
        const float length = (other.anchor - draft.anchor).norm();
        if (other.parent != static_cast<int32_t>(body) || length <= farthest) continue;
        farthest = length;
        frame.end = other.anchor;
    }
    frame.leaf = farthest == 0.0f;
    if (boneEnd && frame.leaf) frame.end = *boneEnd;
    if (boneEnd || !frame.leaf) return;
    Vector3f middle = Vector3f::Zero();
    for (const uint32_t p : draft.particles) middle += voxels.positions[p];
    frame.end = 2.0f * middle / static_cast<float>(draft.particles.size()) - frame.head;
}

}  // namespace

Vector3f acrossLimb(const Vector3f& along, const Vector3f& forward)
{
    return perpendicular(std::abs(forward.dot(along)) < LENGTHWISE ? forward : Vector3f::UnitY(), along);
}

std::optional<LimbFrame> limbFrame(const std::vector<BodyDraft>& drafts, uint32_t body, const Voxels& voxels,
                                   const Vector3f& forward, const std::optional<Vector3f>& boneEnd)
{
    const BodyDraft& draft = drafts[body];
    const float d = voxels.diameter;
    LimbFrame frame;
    frame.head = draft.anchor;
    findEnd(drafts, body, voxels, boneEnd, frame);
    const float length = frame.length(), volume = static_cast<float>(draft.particles.size()) * d * d * d;
    if (length < d || length < SLENDER * std::sqrt(4.0f / std::numbers::pi_v<float> * volume / length)) return {};
    const Vector3f along = frame.along();
    frame.across = acrossLimb(along, forward);
    for (const uint32_t p : draft.particles) {
        const Vector3f from = voxels.positions[p] - frame.head;
        const float way = from.dot(along);
        frame.radius = std::max(frame.radius, (from - way * along).norm() + d);
        frame.before = std::max(frame.before, -way + d);
        frame.after = std::max(frame.after, way - length + d);
    }
    return frame;
}

Vector3f perpendicular(const Vector3f& v, const Vector3f& along)
{
    const Vector3f across = v - v.dot(along) * along;
    return across.norm() > 1e-3f ? Vector3f(across.normalized()) : along.unitOrthogonal().eval();
}

}  // namespace knuckle
