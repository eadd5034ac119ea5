#pragma once

#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sim/world/builder/world_draft.h"

namespace knuckle {

/// Objects and rigid bodies: beginObject(), addBody()..., endObject(pose, velocity).
class BodyBuilder : public virtual WorldDraft {
public:
    /// All bodies and joints up to endObject() belong to one object named `name`.
    void beginObject(std::string name);
    /// A rigid body of particles at `positions` (rest pose of the object) [m]. `surface`: of each particle; if empty, a
    /// box lattice gets a box's, any other body none. `round`: the ball or capsule that they fill, whose volume gives
    /// its mass. @returns the body's index.
    /// @throws std::logic_error for an empty span or a position that is not finite.
    uint32_t addBody(std::string name, std::span<const Vector3f> positions, uint32_t material,
                     Motion motion = Motion::Dynamic, std::span<const SurfaceDistance> surface = {},
                     const RoundShape& round = {});
    /// Holds a body in place, for ever or until a time [s], when it is let go from rest.
    void holdBody(uint32_t body, float releaseTime = std::numeric_limits<float>::infinity());
    /// How a body is let go that is held until a time. @param appears whether it is not there before.
    void throwBody(uint32_t body, const Vector3f& velocity, const Vector3f& spin, bool appears);
    /// Particle::selfMargin for all particles of the open object [diameters].
    void setSelfMargin(float margin);
    /// Marks the body as the cross of a universal joint: its particles touch no others of their assembly, and it gets
    /// most of the mass of those that it shares.
    void markCross(uint32_t body);
    /// Makes two bodies of one object never touch (Body::filtered).
    void filterPair(uint32_t body, uint32_t other);
    /// Places the open object; `velocity` [m/s] and `spin` [rad/s] about its mass centre. @returns the object's index.
    uint32_t endObject(const Pose& pose = {}, const Vector3f& velocity = {0, 0, 0}, const Vector3f& spin = {0, 0, 0});
    /// The particles of a body so far.
    std::span<const uint32_t> particlesOf(uint32_t body) const { return bodyParticles_.at(body); }
    /// The particles of a body so far that it does not share.
    std::vector<uint32_t> ownParticles(uint32_t body) const;
    /// Draws a shape instead of particles of a body that exists (World::bodyShapes).
    void drawShape(uint32_t body, BodyShape shape);
    /// Gives existing objects a mesh, which moves with their bodies.
    void addSkin(const std::shared_ptr<const SkinMesh>& mesh, std::span<const uint32_t> objects, SkinUse use);
};

}  // namespace knuckle
