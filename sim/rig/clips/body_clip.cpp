#include "sim/rig/clips/body_clip.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "sim/base/errors.h"
#include "sim/rig/clips/bone_match.h"
#include "sim/rig/clips/clip_facing.h"
#include "sim/rig/clips/clip_overlaps.h"
#include "sim/rig/clips/joint_turns.h"
#include "sim/world/space/frames.h"

namespace knuckle {

namespace {

constexpr float LEVEL = 0.5f;   // height of a pivot over its mean distance to joints, below which it is level with them
constexpr float ALIKE = 0.02f;  // most mean offset of joints, over their mean distance from the pivot

using Eigen::Matrix3f;
using Eigen::Matrix4f;

Quaternionf turnOf(const Matrix4f& pose)
{
    const Matrix3f m = pose.topLeftCorner<3, 3>().colwise().normalized();
    return Quaternionf(m).normalized();
}

/// How a skeleton's motion becomes an actor's.
struct Mapping {
    std::vector<uint32_t> bones;       ///< Per body, the bone that moves it, or NO_INDEX.
    std::vector<Quaternionf> aligned;  ///< Per body, from the actor's rest pose to the skeleton's.
    Quaternionf facing{1, 0, 0, 0};    ///< From the skeleton's directions to the actor's.
    float scale = 1.0f;                ///< Of ways.
    Vector3f pivot{0, 0, 0};           ///< In the skeleton's rest pose [m].
    bool own = true;
    bool stands = false;  ///< Whether the skeleton at rest stands where the actor does.
};

/// How a body is turned by its bone, in the actor's directions.
Quaternionf turnBy(const Mapping& map, uint32_t body, const Model& source, const std::vector<Matrix4f>& poses)
{
    const uint32_t bone = map.bones[body];
    const Quaternionf turn = turnOf(poses[bone]) * turnOf(source.bones[bone].restPose).conjugate();
    return map.facing * turn * map.facing.conjugate() * map.aligned[body];
}

float lowestOf(const Model& model)
{
    float low = headIn(model.bones[0].restPose).y();
    for (const Bone& bone : model.bones) low = std::min(low, headIn(bone.restPose).y());
    return low;
}

/// The lowest height of any bone in a clip: its ground [m].
float groundOf(const Clip& clip)
{
    float low = std::numeric_limits<float>::max();
    for (const std::vector<Matrix4f>& poses : clip.poses)
        for (const Matrix4f& pose : poses) low = std::min(low, headIn(pose).y());
    return low;
}

Vector3f pivotAt(const Mapping& map, const Model& source, const std::vector<Matrix4f>& poses)
{
    const uint32_t bone = map.bones[0] == NO_INDEX ? 0 : map.bones[0];
    const Matrix4f motion = poses[bone] * source.bones[bone].restPose.inverse();
    return (motion * map.pivot.homogeneous()).head<3>();
}

/// Converts all keys; joints turn only as their types allow.
ActorClip convert(const Actor& actor, const Model& source, const Clip& clip, const Mapping& map)
{
    ActorClip out;
    const auto keys = static_cast<uint32_t>(clip.poses.size());
    out.clip.name = clip.name;
    out.clip.bodyCount = static_cast<uint32_t>(actor.bodies.size());
    if (keys > 1 && clip.duration > 0.0) out.clip.rate = static_cast<float>((keys - 1) / clip.duration);
    JointTurns turns(actor);
    const Vector3f rest = pivotOf(actor);
    Vector3f start = Vector3f::Zero();
    for (uint32_t k = 0; k < keys; ++k) {
        const std::vector<Matrix4f>& poses = clip.poses[k];
        const Vector3f pivot = pivotAt(map, source, poses);
        if (k == 0) {
            const float ground = map.stands ? 0.0f : groundOf(clip) - lowestOf(source);
            start = Vector3f(pivot.x(), ground + map.pivot.y(), pivot.z());
        }
        out.clip.roots.push_back(map.own ? pivot : Vector3f(rest + map.scale * (map.facing * (pivot - start))));
        const auto wanted = [&](uint32_t body) -> std::optional<Quaternionf> {
            if (map.bones[body] == NO_INDEX) return {};
            return turnBy(map, body, source, poses);
        };
        turns.addKey(wanted, out.clip.turns);
    }
    out.notes = turns.notes(clip.name);
    out.notes.insert(out.notes.end(), clip.notes.begin(), clip.notes.end());
    return out;
}

/// Joints that hang on each body; for a universal joint's cross, those beyond it.
std::vector<std::vector<uint32_t>> childrenOf(const Actor& actor)
{
    std::vector<std::vector<uint32_t>> children(actor.bodies.size());
    for (uint32_t j = 0; j < actor.joints.size(); ++j) {
        const uint32_t child = actor.joints[j].child;
        if (!actor.bodies[child].isCross) children[parentBody(actor, child)].push_back(j);
    }
    return children;
}

/// The directions in which a body's limbs leave it, for both skeletons.
struct Limb {
    Vector3f ours{0, 0, 0}, theirs{0, 0, 0};
    uint32_t count = 0;
};

Limb limbOf(const Actor& actor, const Model& source, const Mapping& map, const std::vector<uint32_t>& joints)
{
    Limb limb;
    for (const uint32_t j : joints) {
        const uint32_t bone = map.bones[actor.joints[j].child];
        if (bone == NO_INDEX) continue;
        limb.ours += actor.joints[j].anchor;
        limb.theirs += headIn(source.bones[bone].restPose);
        ++limb.count;
    }
    if (limb.count > 0) {
        limb.ours /= static_cast<float>(limb.count);
        limb.theirs /= static_cast<float>(limb.count);
    }
    return limb;
}

/// Turns limbs that point elsewhere at rest. Ends turn with what they hang on.
void alignLimbs(const Actor& actor, const Model& source, Mapping& map)
{
    const auto children = childrenOf(actor);
    map.aligned.assign(actor.bodies.size(), Quaternionf::Identity());
    const JointTurns turns(actor);
    for (const uint32_t body : turns.order()) {
        const ActorJoint* joint = nullptr;
        for (const ActorJoint& j : actor.joints)
            if (j.child == body) joint = &j;
        if (joint == nullptr) continue;
        map.aligned[body] = map.aligned[joint->parent];
        if (map.bones[body] == NO_INDEX) continue;
        Limb limb = limbOf(actor, source, map, children[body]);
        if (limb.count == 0) continue;
        limb.ours -= joint->anchor;
        limb.theirs = map.facing * (limb.theirs - headIn(source.bones[map.bones[body]].restPose));
        if (limb.ours.norm() > 0.0f && limb.theirs.norm() > 0.0f)
            map.aligned[body] = turnBetween(limb.ours, limb.theirs);
    }
}

/// A joint of the actor and the bone that moves what hangs on it, from the pivots of both at rest.
struct JointPair {
    Vector3f ours, theirs;
};

std::vector<JointPair> jointPairs(const Actor& actor, const Model& source, const Mapping& map)
{
    const Vector3f pivot = pivotOf(actor);
    std::vector<JointPair> pairs;
    for (const ActorJoint& joint : actor.joints) {
        const uint32_t bone = map.bones[joint.child];
        if (bone == NO_INDEX || actor.bodies[joint.child].isCross) continue;
        pairs.push_back({joint.anchor - pivot, map.facing * (headIn(source.bones[bone].restPose) - map.pivot)});
    }
    return pairs;
}

/// The actor's size relative to the skeleton's: by the height of both pivots over the lowest joint, which keeps feet
/// from sliding; if all joints are at one height, by their reach.
float scaleOf(const std::vector<JointPair>& pairs)
{
    float ours = 0.0f, theirs = 0.0f, ourReach = 0.0f, theirReach = 0.0f;
    for (const JointPair& pair : pairs) {
        ours = std::max(ours, -pair.ours.y());
        theirs = std::max(theirs, -pair.theirs.y());
        ourReach += pair.ours.norm();
        theirReach += pair.theirs.norm();
    }
    const auto count = static_cast<float>(pairs.size());
    const bool isHigh = ours * count > LEVEL * ourReach && theirs * count > LEVEL * theirReach;
    if (isHigh) return ours / theirs;
    return ourReach > 0.0f && theirReach > 0.0f ? ourReach / theirReach : 1.0f;
}

/// Whether both have the same rest pose at the same height, up to their units.
bool standsAlike(const Actor& actor, const std::vector<JointPair>& pairs, const Mapping& map)
{
    float reach = 0.0f, off = 0.0f;
    for (const JointPair& pair : pairs) {
        reach += pair.ours.norm();
        off += (map.scale * pair.theirs - pair.ours).norm();
    }
    const float lift = std::abs(map.scale * map.pivot.y() - pivotOf(actor).y());
    return off < ALIKE * reach && lift * static_cast<float>(pairs.size()) < ALIKE * reach;
}

Mapping mapForeign(const Actor& actor, const Figure& figure)
{
    const Model& source = figure.model;
    const ActorAnatomy anatomy = anatomyOf(actor);
    Mapping map;
    map.own = false;
    map.bones = matchBones(anatomy, figure);
    if (std::ranges::all_of(map.bones, [](uint32_t bone) { return bone == NO_INDEX; })) {
        const auto firstNames = [](const auto& named) {
            std::vector<std::string> names;
            for (size_t i = 0; i < std::min<size_t>(8, named.size()); ++i) names.push_back(named[i].name);
            return fmt::format("{}", fmt::join(names, ", "));
        };
        throw InputError(fmt::format("none of its bones ({}) is one of the actor's ({})", firstNames(source.bones),
                                     firstNames(actor.joints)));
    }
    map.facing = facingOf(anatomy, figure, map.bones);
    const Limb root = limbOf(actor, source, map, childrenOf(actor)[0]);
    map.pivot = root.count > 0 ? root.theirs
                               : headIn(source.bones[map.bones[0] == NO_INDEX ? 0 : map.bones[0]].restPose);
    const std::vector<JointPair> pairs = jointPairs(actor, source, map);
    map.scale = scaleOf(pairs);
    map.stands = standsAlike(actor, pairs, map);
    alignLimbs(actor, source, map);
    return map;
}

}  // namespace

Vector3f pivotOf(const Actor& actor)
{
    Vector3f sum = Vector3f::Zero();
    float count = 0.0f;
    for (const ActorJoint& joint : actor.joints)
        if (joint.parent == 0) {
            sum += joint.anchor;
            count += 1.0f;
        }
    if (count > 0.0f) return sum / count;
    for (const Vector3f& p : actor.particles) sum += p;
    return sum / static_cast<float>(actor.particles.size());
}

ActorClip ownClip(const Actor& actor, const Model& model, const Clip& clip)
{
    Mapping map;
    for (const ActorBody& body : actor.bodies) {
        const auto bone = std::ranges::find(model.bones, body.name, &Bone::name);
        map.bones.push_back(bone == model.bones.end() ? NO_INDEX : static_cast<uint32_t>(bone - model.bones.begin()));
    }
    map.aligned.assign(actor.bodies.size(), Quaternionf::Identity());
    map.pivot = pivotOf(actor);
    return convert(actor, model, clip, map);
}

ActorClip foreignClip(const Actor& actor, const Figure& source, const Clip& clip)
{
    const Mapping map = mapForeign(actor, source);
    ActorClip out = convert(actor, source.model, clip, map);
    std::vector<std::string> still;
    for (uint32_t b = 0; b < actor.bodies.size(); ++b)
        if (map.bones[b] == NO_INDEX && !actor.bodies[b].isCross) still.push_back(actor.bodies[b].name);
    if (!still.empty())
        out.notes.push_back(
            fmt::format("Clip '{}' does not move {}: no bone of its file is that.", clip.name, fmt::join(still, ", ")));
    return out;
}

std::vector<Quaternionf> turnsOf(const BodyClip& clip, uint32_t body)
{
    std::vector<Quaternionf> turns;
    for (uint32_t k = 0; k < clip.keyCount(); ++k) turns.push_back(clip.turns[size_t{k} * clip.bodyCount + body]);
    return turns;
}

}  // namespace knuckle
