#pragma once

#include <utility>
#include <vector>

#include "sim/world/builder/world_draft.h"

namespace knuckle {

/// Clips, and bodies that move by them, are driven to them and are let go.
class MotionBuilder : public virtual WorldDraft {
public:
    /// @returns its index, for ClipPlay::clip.
    uint32_t addClip(BodyClip clip);
    /// From the start, clips move the bodies of an existing object. Their joints must form a tree.
    void animate(Animation animation);
    /// Drives an animated object to its clips while it responds.
    void drive(Puppet puppet) { world_.puppets.push_back(std::move(puppet)); }
    /// Lets go of a body at a time [s]; a time after it was caught lets go of it again. @param driven whether a
    /// puppet's body is driven from then on, else limp.
    void letGo(uint32_t body, float time, bool driven);
    /// Lets go of a body that is held or animated at a time [s].
    void releaseBody(uint32_t body, float time);
    /// Lets go of bodies that are held or animated when something happens to them.
    void addRelease(Release release);

private:
    /// Puts animated bodies where their clips begin, with the velocity there.
    void poseAnimated(const Animation& animation);
    /// As linksOf(), before build() records the joints.
    std::vector<AnimatedLink> draftedLinks(const Animation& animation) const;
};

}  // namespace knuckle
