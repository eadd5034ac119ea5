#include "sim/rig/clips/joint_turns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/base/angles.h"

namespace knuckle {

namespace {

constexpr float MUCH = 0.35f;  // of a turn: leaving out more is noted [rad]

/// The part of a turn that is about an axis.
Quaternionf twistAbout(const Vector3f& axis, const Quaternionf& turn)
{
    const Vector3f along = turn.vec().dot(axis) * axis;
    const Quaternionf twist(turn.w(), along.x(), along.y(), along.z());
    return twist.norm() > 1e-6f ? twist.normalized() : Quaternionf::Identity();
}

/// The turn about an axis that brings one direction nearest to another.
Quaternionf turnOnto(const Vector3f& axis, const Vector3f& from, const Vector3f& to)
{
    const Vector3f across = axis.cross(from);
    return Quaternionf(Eigen::AngleAxisf(std::atan2(to.dot(across), to.dot(from)), axis));
}

}  // namespace

JointTurns::JointTurns(const Actor& actor)
    : actor_(actor), jointOf_(actor.bodies.size(), NO_INDEX), leftOut_(actor.bodies.size(), 0.0f)
{
    for (uint32_t j = 0; j < actor.joints.size(); ++j) jointOf_[actor.joints[j].child] = j;
    std::vector<bool> placed(actor.bodies.size(), false);
    while (order_.size() < actor.bodies.size()) {
        const size_t before = order_.size();
        for (uint32_t b = 0; b < actor.bodies.size(); ++b) {
            if (placed[b] || (jointOf_[b] != NO_INDEX && !placed[actor.joints[jointOf_[b]].parent])) continue;
            placed[b] = true;
            order_.push_back(b);
        }
        if (order_.size() == before) break;  // a loop, which an actor does not have
    }
}

Quaternionf JointTurns::held(uint32_t body, const Quaternionf& relative)
{
    const ActorJoint& joint = actor_.joints[jointOf_[body]];
    Quaternionf turn = relative;
    if (joint.type == JointType::Stiff) turn.setIdentity();
    if (joint.type == JointType::Hinge || joint.type == JointType::Universal) turn = twistAbout(joint.axis, relative);
    leftOut_[body] = std::max(leftOut_[body], turn.angularDistance(relative));
    return turn;
}

Quaternionf JointTurns::crossTurn(uint32_t cross, const Quaternionf& parent, const Wanted& wanted) const
{
    const auto next = std::ranges::find(actor_.joints, cross, &ActorJoint::parent);
    if (next == actor_.joints.end()) return Quaternionf::Identity();
    const std::optional<Quaternionf> behind = wanted(next->child);
    if (!behind) return Quaternionf::Identity();
    return turnOnto(actor_.joints[jointOf_[cross]].axis, next->axis, parent.conjugate() * *behind * next->axis);
}

void JointTurns::addKey(const Wanted& wanted, std::vector<Quaternionf>& turns)
{
    const size_t first = turns.size();
    std::vector<Quaternionf> whole(actor_.bodies.size(), Quaternionf::Identity());
    turns.resize(first + actor_.bodies.size(), Quaternionf::Identity());
    for (const uint32_t b : order_) {
        const bool isFirst = jointOf_[b] == NO_INDEX;
        const Quaternionf parent = isFirst ? Quaternionf::Identity() : whole[actor_.joints[jointOf_[b]].parent];
        Quaternionf turn = Quaternionf::Identity();
        if (actor_.bodies[b].isCross) turn = crossTurn(b, parent, wanted);
        else if (const std::optional<Quaternionf> own = wanted(b))
            turn = isFirst ? *own : held(b, parent.conjugate() * *own);
        whole[b] = parent * turn;
        if (!last_.empty() && turn.dot(last_[b]) < 0.0f) turn.coeffs() = -turn.coeffs();
        turns[first + b] = turn;
    }
    last_.assign(turns.begin() + static_cast<std::ptrdiff_t>(first), turns.end());
}

std::vector<std::string> JointTurns::notes(const std::string& clip) const
{
    std::vector<std::string> notes;
    for (uint32_t b = 0; b < leftOut_.size(); ++b) {
        if (leftOut_[b] < MUCH) continue;
        const bool stiff = actor_.joints[jointOf_[b]].type == JointType::Stiff;
        notes.push_back(fmt::format("Clip '{}' turns {} by {:.0f} degrees as its {} joint cannot: left out.", clip,
                                    actor_.bodies[b].name, degreesOf(leftOut_[b]), stiff ? "stiff" : "hinge"));
    }
    return notes;
}

}  // namespace knuckle
