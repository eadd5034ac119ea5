#include "sim/rig/clips/bone_match.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "sim/rig/anatomy/facing.h"
#include "sim/rig/clips/body_clip.h"

namespace knuckle {

namespace {

/// "mixamorig:LeftArm" and "leftarm" are one name.
std::string plainName(const std::string& name)
{
    std::string plain;
    for (const char c : name.substr(name.rfind(':') + 1))  // npos + 1 is 0
        if (std::isalnum(static_cast<unsigned char>(c))) plain += static_cast<char>(std::tolower(c));
    return plain;
}

/// A part and its side.
using PartKey = std::pair<BodyPart, int>;

/// Bones of each part, in order from the root: a spine has several.
std::map<PartKey, std::vector<uint32_t>> partsOf(const std::vector<BoneAnatomy>& anatomy)
{
    std::map<PartKey, std::vector<uint32_t>> parts;
    for (uint32_t b = 0; b < anatomy.size(); ++b) {
        const BoneAnatomy& bone = anatomy[b];
        const bool known = bone.part != BodyPart::Other && bone.part != BodyPart::Finger;
        if (known && bone.role == BoneRole::Limb) parts[{bone.part, bone.side}].push_back(b);
    }
    return parts;
}

}  // namespace

Model skeletonOf(const Actor& actor)
{
    Model skeleton;
    for (uint32_t b = 0; b < actor.bodies.size(); ++b) {
        Bone bone{actor.bodies[b].isCross ? std::string() : actor.bodies[b].name, parentBody(actor, b)};
        const auto joint = std::ranges::find(actor.joints, b, &ActorJoint::child);
        if (joint != actor.joints.end()) bone.restPose.block<3, 1>(0, 3) = joint->anchor;
        else bone.restPose.block<3, 1>(0, 3) = pivotOf(actor);
        skeleton.bones.push_back(bone);
    }
    return skeleton;
}

ActorAnatomy anatomyOf(const Actor& actor)
{
    ActorAnatomy anatomy{skeletonOf(actor), {}};
    anatomy.bones = readAnatomy(anatomy.skeleton);
    Model skeleton = anatomy.skeleton;
    for (uint32_t b = 0; b < actor.bodies.size(); ++b) {
        for (const uint32_t particle : actor.bodies[b].particles) {
            skeleton.vertices.push_back(actor.particles[particle]);
            skeleton.skin.push_back({{b}, {1.0f}});
        }
    }
    settleSides(skeleton, anatomy.bones);
    anatomy.isFacingKnown = isFacingKnown(skeleton, anatomy.bones);
    return anatomy;
}

std::vector<uint32_t> matchBones(const ActorAnatomy& actor, const Figure& source)
{
    std::map<std::string, uint32_t> byName;
    for (uint32_t b = 0; b < source.tree.size(); ++b) byName.try_emplace(plainName(source.model.bones[b].name), b);
    std::vector<uint32_t> match(actor.bones.size(), NO_INDEX);
    for (uint32_t b = 0; b < match.size(); ++b) {
        const std::string& name = actor.skeleton.bones[b].name;
        if (const auto found = byName.find(plainName(name)); found != byName.end() && !name.empty())
            match[b] = found->second;
    }
    const auto theirs = partsOf(source.anatomy);
    for (const auto& [part, ours] : partsOf(actor.bones)) {
        const auto found = theirs.find(part);
        if (found == theirs.end()) continue;
        // Aligns the last bones of both: the chest, the wrist.
        const size_t n = ours.size(), m = found->second.size();
        for (size_t i = 0; i < n; ++i)
            if (match[ours[i]] == NO_INDEX) match[ours[i]] = found->second[((i + 1) * m + n - 1) / n - 1];
    }
    return match;
}

}  // namespace knuckle
