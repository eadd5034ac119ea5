#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace knuckle {

enum class SolverKind : uint32_t {
    Impulse,  ///< Default: contacts and joints as warm-started impulses with the effective mass of the bodies.
    Paper,    ///< Count-averaged Jacobi on single particles, joints as the mean of goals (paper, section 3).
};
enum class RotationMethod : uint32_t {
    Quaternion,   ///< Warm-started quaternion, Newton steps (after Mueller et al. 2016).
    Householder,  ///< The paper's: eigendecomposition of A^T A by QR with Householder reflections (eqs. 11-17).
    Higham,       ///< Higham and Noferini 2016: the dominant eigenvector of a symmetric 4x4 matrix made of A.
};
enum class GridKind : uint32_t {
    Lattice,  ///< Cells contiguous in x, wrapped: three neighbours are one range.
    Hash,     ///< The hash of Teschner et al. 2003.
};
enum class ReductionKind : uint32_t {
    Auto,    ///< Thread on software devices, Group on hardware.
    Thread,  ///< One thread walks a body's block of links.
    Group,   ///< One work group per body, reduced in shared memory.
    Steps,   ///< The paper's: ceil(log2 p) + 1 dispatches over the whole link array (eq. 10).
};
enum class VelocityOrder : uint32_t { First = 1, Second = 2 };

inline constexpr float SHORTEST_TIME_STEP = 1e-4f;  ///< [s]

/// How a step is computed. The defaults work best; paperSettings() gives the paper's own choices.
struct Settings {
    SolverKind solver = SolverKind::Impulse;
    RotationMethod rotation = RotationMethod::Quaternion;
    GridKind grid = GridKind::Lattice;
    ReductionKind reduction = ReductionKind::Auto;
    VelocityOrder velocityOrder = VelocityOrder::Second;
    Eigen::Vector3f gravity{0.0f, -9.81f, 0.0f};  ///< [m/s2]
    float timeStep = 1.0f / 60.0f;                ///< One step [s], 1e-4 ... 0.1. A frame is one or more steps.
    uint32_t substeps = 0;                        ///< Per step, 1 ... 64; 0: automaticSubsteps(). Fluids have at least
                                                  ///< leastFluidSubsteps().
    uint32_t iterations = 2;                      ///< Per substep, 1 ... 64.
    uint32_t stabilization = 0;                   ///< Stabilization iterations per substep, 0 ... 16 (paper, 3.3).
    float contactMargin = 0.2f;                   ///< Candidates within (1 + margin) diameters, 0.05 ... 1 (3.1: 0.2).
    float freeze = 0.0f;                          ///< An assembly whose particles move by less in a second stays in
                                                  ///< place until a neighbour moves [radii], 0 ... 0.8; 0 off (3.1:
                                                  ///< 0.5).
    float virtualParticles = 0.01f;               ///< c of eq. 18, relative to the mean diagonal of A at rest, 0 ... 1.
    bool splitSharedMass = true;                  ///< A particle of k bodies weighs m/k in each: conserves momentum.
    float linearDamping = 0.0f;                   ///< [1/s], 0 ... 100.
    float maxSpeed = 100.0f;                      ///< [m/s], > 0.
    float massScaling = 0.0f;                     ///< k [1/m], 0 ... 10: contacts see masses m exp(-k height); 0: off.
    float vorticity = 0.0f;                       ///< How much of the lost swirls of fluids is given back, 0 ... 1.
    float sleepSpeed = 0.0f;                      ///< Assemblies that stay slower sleep, with all that they touch
                                                  ///< [m/s]; 0: off.

    /// The first substep that begins at or after a time [s]; NO_SUBSTEP for infinity.
    uint32_t substepAt(float time) const;
};

/// Substeps in which something as fast as a fall of 1 m (4.5 m/s) moves at most a fifth of a diameter, 4 to 16. Half as
/// many again for the paper's solver: its particles part by themselves, and bodies that hit each other faster than that
/// may get caught in each other's lattices.
/// @param diameter of particles [m]. @param timeStep [s].
uint32_t automaticSubsteps(float diameter, float timeStep, SolverKind solver);

/// The same for fluids: pressure goes about a particle far in a substep, so fluid at rest is denser than asked by about
/// 0.59 of pressure / density (timeStep / (substeps spacing))^2; that stays below 1 %. 4 to 32, and
/// leastFluidSubsteps().
/// @param spacing of fluid particles [m]. @param pressure over density [m2/s2]; taken as at least that of twenty
/// layers.
/// @param timeStep [s].
uint32_t automaticFluidSubsteps(float spacing, float pressure, float timeStep);

/// With fewer substeps fluid does not come to rest: if pressure lags behind by more than 6 % of the density, it boils.
/// 1 to 64. @param pressure over density at its floor [m2/s2].
uint32_t leastFluidSubsteps(float spacing, float pressure, float timeStep);

/// The pressure that a fluid's surface tension causes [Pa]: its pull on particles reaches two rest distances.
float cohesionPressure(float surfaceTension, float spacing);

/// The paper's own choices: averaged Jacobi with stabilization, Householder-QR, eq. 10's reduction, the hash, freezing
/// at half a radius, first-order velocities; and settings that make them work: half as many substeps again as the
/// default's, 4 iterations of each, mass scaling, split masses at shared particles.
Settings paperSettings();

}  // namespace knuckle
