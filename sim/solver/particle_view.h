#pragma once

#include <epoxy/gl.h>

#include <cstdint>

namespace knuckle {

/// What a renderer needs to draw the simulation: names of the solver's own GL buffers, never copied or uploaded.
/// Valid as long as the Solver lives; the contents change with every step.
struct ParticleView {
    GLuint positions = 0;       ///< particleCount x vec4: xyz [m], w: 0, or 1 for an inactive fluid particle.
    GLuint velocities = 0;      ///< particleCount x vec4: xyz [m/s], w unspecified.
    GLuint bodyCentres = 0;     ///< bodyCount x vec4: xyz mass centre [m], w unspecified.
    GLuint bodyRotations = 0;   ///< bodyCount x vec4: quaternion xyzw from the rest pose.
    GLuint colliderPlaces = 0;  ///< colliderCount x 2 x vec4: xyz [m]; quaternion xyzw.
    uint32_t particleCount = 0;
    uint32_t bodyCount = 0;
    uint32_t colliderCount = 0;
    float radius = 0.05f;               ///< [m]
    uint32_t solidCount = 0xffffffffu;  ///< Particles after these are fluid.
    float fluidSpacing = 0.05f;         ///< Rest distance of fluid particles [m].
    GLuint foamPlaces = 0;              ///< foamCount x vec4: xyz [m], w: opacity of a point of foam, 0: none is there.
    uint32_t foamCount = 0;
    GLuint fluidForms = 0;  ///< particleCount x uint: spheroids of fluid particles (math/spheroid.glsl); 0: none are.
    GLuint distanceStates = 0;  ///< distanceCount x vec4, distances of ropes and cloth in the order of
                                ///< strandOrder(): z: 1 if torn. 0: none can tear.
    uint32_t distanceCount = 0;
    // Of fluids, as of the last substep; 0: there are none. As many slots as particles:
    GLuint particleSlots = 0;   ///< particleCount x uint: the slot of each.
    GLuint slotParticles = 0;   ///< uint: its particle.
    GLuint slotPressures = 0;   ///< 2 x uvec4: shaders/sim/fluid/pressure/slot_pressures.glsl.
    GLuint slotShapes = 0;      ///< 2 x vec4: the same.
    GLuint slotCovers = 0;      ///< vec4: w: density over that at rest.
    float pressureUnit = 0.0f;  ///< Of a stored multiplier [Pa].
    // Of each particle, where World::shown has them, else 0:
    GLuint ages = 0;           ///< float: time since it came into the scene [s].
    GLuint contactForces = 0;  ///< float, of solid ones: ShownStage::contactForces [N].
};

}  // namespace knuckle
