#include "sim/rig/joints/fold.h"

#include <cmath>
#include <optional>

#include "sim/rig/joints/joint_particles.h"
#include "sim/rig/limbs/limb_frame.h"

namespace knuckle {

namespace {

constexpr float BENT = 0.15f;          // sine of the bend at rest above which a fold is taken from it
constexpr float STRONGLY_BENT = 0.5f;  // ... even against the way that bodies fold
constexpr float CLIP_BENT = 0.25f;  // sine of the root mean square bend of clips, above which a fold is taken from them
constexpr float ONE_WAY = 0.8f;     // least sum of bends in clips, over the sum of their squares
constexpr float SAME_WAY = 0.7f;    // cosine above which the ways of the rest pose and of clips agree
constexpr float ACROSS = 0.8f;      // cosine with the limb below which a direction lies across it

Vector3f usualFold(const LimbStance& limb)
{
    const Vector3f up = Vector3f::UnitY();
    Vector3f wanted = limb.forward;
    if (limb.part == BodyPart::Shin) wanted = -limb.forward;
    if (limb.part == BodyPart::Lever) wanted = up;
    if (limb.part == BodyPart::Finger) wanted = -(up + limb.outward).normalized();
    if (std::abs(wanted.dot(limb.along)) >= ACROSS) wanted = limb.part == BodyPart::Lever ? limb.forward : up;
    if (std::abs(wanted.dot(limb.along)) >= ACROSS) wanted = limb.forward;
    return perpendicular(wanted, limb.along);
}

/// The direction that leads further from straight, in the plane of both parts.
std::optional<Vector3f> foldAtRest(const LimbStance& limb, const Vector3f& usual)
{
    const float bend = limb.above.cross(limb.along).norm(), straight = limb.above.dot(limb.along);
    if (bend <= BENT) return {};
    const Vector3f fold = (straight * limb.along - limb.above).normalized();
    const bool rightWay = fold.dot(usual) > 0.5f;
    const bool slightly = bend < STRONGLY_BENT && straight > 0.0f;
    const bool mayBeWrong = limb.part == BodyPart::Finger || (limb.part != BodyPart::Lever && limb.upright && slightly);
    if (!rightWay && mayBeWrong) return {};
    return fold;
}

std::optional<Vector3f> foldInClips(const LimbStance& limb, std::span<const Turns> clips)
{
    // Large bends count most. Thumbs are spread at rest, so a finger's bends are measured from its rest pose.
    const Vector3f& straight = limb.part == BodyPart::Finger ? limb.along : limb.above;
    Vector3f sum = Vector3f::Zero();
    float total = 0.0f, count = 0.0f;
    for (const Turns& turns : clips) {
        for (const Quaternionf& turn : turns) {
            const Vector3f bend = straight.cross(turn * limb.along);
            sum += bend.norm() * bend;
            total += bend.squaredNorm();
            count += 1.0f;
        }
    }
    if (count == 0.0f || total < CLIP_BENT * CLIP_BENT * count || sum.norm() < ONE_WAY * total) return {};
    const Vector3f way = sum.cross(limb.along);
    if (way.norm() < ONE_WAY * sum.norm()) return {};
    return way.normalized();
}

}  // namespace

Vector3f foldDirection(const LimbStance& limb, std::span<const Turns> clips)
{
    const Vector3f usual = usualFold(limb);
    const std::optional<Vector3f> atRest = foldAtRest(limb, usual);
    const bool folds = limb.part == BodyPart::Shin || limb.part == BodyPart::Forearm || limb.part == BodyPart::Finger;
    const std::optional<Vector3f> moving = folds ? foldInClips(limb, clips) : std::nullopt;
    const float alike = moving && atRest ? atRest->dot(*moving) : 0.0f;
    const bool opens = limb.part == BodyPart::Finger && alike < -SAME_WAY;  // a fist, in clips
    if (moving && !opens && alike < SAME_WAY) return *moving;
    return atRest.value_or(usual);
}

float restBend(const LimbStance& limb, const Vector3f& axis)
{
    return limb.above.isZero() ? 0.0f : std::atan2(limb.along.dot(axis.cross(limb.above)), limb.along.dot(limb.above));
}

}  // namespace knuckle
