#pragma once

#include <set>
#include <utility>
#include <vector>

#include "tests/solver/solver_test.h"

namespace knuckle::test {

/// Rounding of a distance of up to half a metre: a dozen roundings of 2^-24 of it. A pair nearer to its limit than that
/// may be found or not.
inline constexpr float DISTANCE_ROUNDING = 4e-7f;

/// Particles at random places, independent of their bodies, those of bodies in a small space: pairs of every kind come
/// near each other. The lists have room for all.
class SearchBench : public KernelFixture {
public:
    SearchBench();

    uint32_t count() const { return stages.parameters.particleCount; }
    uint32_t moverOf(uint32_t particle) const { return places[particle].x; }
    uint32_t rankOf(uint32_t particle) const { return places[particle].y; }
    bool isFast(uint32_t particle) const { return reaches[moverOf(particle)] > 0.0f; }
    /// Implemented anew from the rules: never of one body, or of two bodies that limits hold; within an assembly,
    /// neither a universal joint's cross nor particles nearer than a diameter and a margin at rest.
    bool mayTouch(uint32_t i, uint32_t j) const;
    /// The distance below which two particles are a pair [m]: larger for fast movers.
    float limitOf(uint32_t i, uint32_t j) const;
    float distance(uint32_t i, uint32_t j) const { return (vec3(found[i]) - vec3(found[j])).norm(); }

    /// Moves the particles to places for which contacts are found.
    void place(const std::vector<gpu::vec4>& positions);
    /// Makes some movers of each kind look further for contacts, up to the largest reach.
    void makeSomeFast();
    /// Makes movers look further for contacts by these lengths [m].
    void setReaches(const std::vector<float>& lengths);
    /// The pairs that the search noted, by first particle, in the order in which it noted them.
    std::vector<std::vector<uint32_t>> notedPairs() const;
    /// What it noted, in the order of arrival: first and second particle, place, arrival.
    std::vector<gpu::uvec4> candidates() const;
    /// Tells kernels of less room than the stages have.
    void narrow(uint32_t candidates, uint32_t pairs, uint32_t colliderPairs);

    std::vector<gpu::vec4> found;
    std::vector<gpu::uvec2> places;
    std::vector<float> reaches;              ///< Per mover [m].
    std::vector<std::set<uint32_t>> bodies;  ///< Per particle.
};

/// Frictions as contacts have them, static and kinetic, in half floats of 11 bits.
inline constexpr float HALF_ROUNDING = 0x1p-11f;
Eigen::Vector2f halves(uint32_t packedFrictions);

/// The distance of two particles of an assembly at rest, and the distance beyond which they may touch [m].
float restDistance(const Particle& a, const Particle& b);
float leastRestDistance(const Particle& a, const Particle& b);

}  // namespace knuckle::test
