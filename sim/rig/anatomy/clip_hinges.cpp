#include "sim/rig/anatomy/clip_hinges.h"

#include <algorithm>

#include "sim/rig/anatomy/clip_turns.h"

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float MUCH = 0.35f;    // least turn that shows an axis [rad]
constexpr float ASIDE = 0.035f;  // turns about other axes up to this do not count [rad]

std::vector<Vector3f> turnsOf(const Model& model, uint32_t bone, uint32_t parent)
{
    std::vector<Vector3f> vectors;
    for (const Turns& turns : clipTurns(model, bone, parent))
        for (const Eigen::Quaternionf& turn : turns) {
            const Eigen::AngleAxisf about(turn);
            vectors.push_back(about.angle() * about.axis());
        }
    return vectors;
}

}  // namespace

void readClipHinges(const Model& model, std::vector<BoneAnatomy>& anatomy)
{
    for (uint32_t b = 0; b < anatomy.size(); ++b) {
        BoneAnatomy& bone = anatomy[b];
        const bool unknown = bone.part == BodyPart::Other && bone.source == AnatomySource::None;
        if (!(unknown || bone.part == BodyPart::Lever) || bone.role != BoneRole::Limb || bone.parent < 0) continue;
        const std::vector<Vector3f> turns = turnsOf(model, b, static_cast<uint32_t>(bone.parent));
        const auto most = std::ranges::max_element(turns, {}, [](const Vector3f& turn) { return turn.norm(); });
        if (most == turns.end() || most->norm() < MUCH) continue;
        const Vector3f axis = most->normalized();
        const auto isAside = [&](const Vector3f& turn) { return turn.cross(axis).norm() > ASIDE; };
        if (std::ranges::any_of(turns, isAside)) continue;
        bone.source = AnatomySource::Clip;
        bone.axis = axis;
    }
}

}  // namespace knuckle
