#include <algorithm>
#include <map>

#include "sim/world/builder/builder.h"
#include "sim/world/joint/joint_fit.h"
#include "sim/world/joint/joint_order.h"

namespace knuckle {

namespace {

/// Merges two descriptions of one pair's joint: the weaker strength holds, and all limits.
void merge(JointDraft& into, const JointDraft& from)
{
    JointStrength& strength = into.joint.strength;
    strength.force = std::min(strength.force, from.joint.strength.force);
    strength.torque = std::min(strength.torque, from.joint.strength.torque);
    strength.time = std::min(strength.time, from.joint.strength.time);
    if (!from.joint.limits.any()) return;
    const bool same = into.joint.parent == from.joint.parent;
    into.joint.limits = from.joint.limits;
    into.axis = same ? from.axis : Vector3f(-from.cone);
    into.cone = same ? from.cone : Vector3f(-from.axis);
}

/// Joints by pairs of bodies: the described ones, and those of pairs that share particles without a description.
class JointList {
public:
    explicit JointList(const World& world) : world_(world) {}

    void describe(JointDraft draft)
    {
        const auto [found, isNew] = ofPair_.try_emplace(pairOf(draft.joint.parent, draft.joint.child), drafts.size());
        if (isNew) drafts.push_back(std::move(draft));
        else merge(drafts[found->second], draft);
    }

    void shareAsDescribed(uint32_t particle, uint32_t a, uint32_t b)
    {
        const auto found = ofPair_.find(pairOf(a, b));
        if (found == ofPair_.end()) return;
        drafts[found->second].joint.particles.push_back(particle);
        covered_.connect(particle, a, b);
    }

    /// After all of those: adds a joint if none connects the two through the particle.
    void shareOtherwise(uint32_t particle, uint32_t a, uint32_t b)
    {
        if (!covered_.connect(particle, a, b)) return;
        const auto [found, isNew] = ofPair_.try_emplace(pairOf(a, b), drafts.size());
        if (isNew) drafts.push_back({{world_.bodies[a].name + "-" + world_.bodies[b].name, JointType::Ball, a, b}});
        drafts[found->second].joint.particles.push_back(particle);
    }

    std::vector<JointDraft> drafts;

private:
    static std::pair<uint32_t, uint32_t> pairOf(uint32_t a, uint32_t b) { return std::minmax({a, b}); }

    const World& world_;
    std::map<std::pair<uint32_t, uint32_t>, size_t> ofPair_;
    SharedParticles covered_;
};

}  // namespace

void WorldBuilder::recordJoints()
{
    JointList list(world_);
    for (JointDraft& draft : joints_) list.describe(std::move(draft));
    for (const auto share : {&JointList::shareAsDescribed, &JointList::shareOtherwise})
        for (uint32_t p = 0; p < owners_.size(); ++p)
            for (size_t i = 0; i < owners_[p].size(); ++i)
                for (size_t j = i + 1; j < owners_[p].size(); ++j) (list.*share)(p, owners_[p][i], owners_[p][j]);
    for (JointDraft& draft : list.drafts) {
        Joint& joint = draft.joint;
        if (!joint.particles.empty()) {
            const JointFit fit = fitJoint(world_, joint.child, joint.parent, joint.particles, draft.axis, draft.cone,
                                          joint.turn);
            joint.type = fit.type;
            joint.childSide = fit.body;
            joint.parentSide = fit.parent;
        }
        world_.joints.push_back(std::move(joint));
    }
    recordGears();
}

void WorldBuilder::recordGears()
{
    const auto indexOf = [&](const HingeBodies& hinge) {
        const auto found = std::ranges::find_if(
            world_.joints, [&](const Joint& joint) { return joint.connects(hinge.parent, hinge.child); });
        return static_cast<uint32_t>(found - world_.joints.begin());
    };
    for (const GearDraft& gear : gears_)
        world_.gears.push_back({gear.name, indexOf(gear.first), indexOf(gear.second), gear.ratio});
}

}  // namespace knuckle
