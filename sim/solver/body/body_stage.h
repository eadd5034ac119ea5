#pragma once

#include "sim/solver/stage.h"

namespace knuckle {

/// Movers (bodies and loose particles): their predictions, the impulses on them, and their moves. Fields as in
/// shaders/sim/common/bodies/fields.glsl.
class BodyStage : public Stage {
public:
    /// @param onParticles whether anything besides contacts and joints acts on single particles.
    BodyStage(const StageSetup& setup, bool onParticles);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    void predict(Recorder& recorder) const;
    /// Applies the last impulses of contacts again, in the order of a new search's lists.
    void warmStart(Recorder& recorder) const;
    /// Sums the impulses of an iteration, and matches each mover to them. @param again except those of stacks, which
    /// the iteration before has moved.
    void solve(Recorder& recorder, bool again) const;
    void integrate(Recorder& recorder) const;
    /// Puts particles where their bodies have them, at the end of a step.
    void placeParticles(Recorder& recorder) const;

    // What never changes.
    Buffer<gpu::ParticleRigidBodyLink> links;  ///< The paper's listing 1, of bodies and then of clusters.
    Buffer<gpu::uvec2> particleLinks;          ///< Per particle: first entry and count in linksOfParticle.
    Buffer<gpu::uvec2> linksOfParticle;        ///< Per link, grouped by particle: link, body.
    Buffer<gpu::Body> bodyInfo;                ///< Per body.
    Buffer<uint32_t> bodyOrder;                ///< Bodies that may respond: those without joints, then those with.
    Buffer<gpu::vec4> bodyMoments;   ///< Per body: columns of the sum of m r r^T [kg m2]; w of one: radius [m].
    Buffer<gpu::vec4> bodyInertias;  ///< Per body, two, inverse: xx, yy, zz, 1/mass; xy, xz, yz.
    Buffer<gpu::vec4> bodyThrows;    ///< Per body of bodyReleases, five: velocity field, centre. Empty: none is thrown.
    Buffer<gpu::vec4> bodyRounds;    ///< Per body, two: ends of its centre line [m]; w: radius, rolling friction.
    Buffer<gpu::Mover> moverInfo;    ///< Per mover.
    Buffer<gpu::uvec2> bodyReleases;  ///< Bodies that may be let go: body, substep that it responds in first.
    // State, per mover.
    Buffer<uint32_t> moverStates;                           ///< MOVER_*.
    Buffer<gpu::vec4> moverCentres, moverRotations;         ///< c and Q: when a substep begins, or (paper) now.
    Buffer<gpu::vec4> moverVelocities, oldMoverVelocities;  ///< Fields [m/s]; the second: a substep before.
    Buffer<gpu::vec4> oldMoverMoves;                        ///< Field: the last substep's move [m].
    // Within a substep, per mover.
    Buffer<gpu::vec4> moverMoves;           ///< Move of c since it began [m]; w: number of impulses over which its mass
                                            ///< is split.
    Buffer<gpu::vec4> moverRotationDeltas;  ///< The rotation since it began: a quaternion.
    Buffer<gpu::vec4> bodyPushes;           ///< Per body, a field: what contacts and its particles add to it [kg m].
    Buffer<gpu::vec4> bodyParticlePushes;   ///< The part of it that acts on its particles, if anything does.
    Buffer<gpu::vec4> bodyLoads;         ///< Per body with joints, four: what acts on it, and how hard it is to turn.
    Buffer<gpu::vec4> moverPredictions;  ///< Field: the untouched move, A of eq. 9 after it.
    Buffer<gpu::vec4> moverImpulses;     ///< Field: what its contacts add to it [kg m].
    Buffer<gpu::vec4> moverChanges;      ///< Field: how they last changed; w of the first: relaxation.
    Buffer<gpu::vec4> particleImpulses;  ///< Per particle, by rank: impulse that acts on it alone [kg m].
    // The channel of constraints (row_plan.h).
    Buffer<gpu::uvec2> bodyRows;           ///< Per body: its first row, and how many.
    Buffer<gpu::vec4> rowArms;             ///< Per row: where in the body it acts [m].
    Buffer<gpu::vec4> rowImpulses;         ///< Per row: of this substep [kg m].
    Buffer<gpu::vec4> rowAngularImpulses;  ///< Per row, where any has one: about the body's centre [kg m2].

private:
    void uploadLinks(const StageSetup& setup);
    void uploadMovers(const StageSetup& setup);
    void uploadRows(const RowPlan& rows);

    uint32_t looseCount() const;

    const gpu::StepParameters& parameters_;
    bool onParticles_, solves_, hasFree_, hasJointed_, hasLoose_, releases_, throws_, stacks_;
    Defines onParticle_, warm_, angular_, jointed_, thrown_;
    Pass release_{*this, "body/mover_release", thrown_, releases_};
    Pass predictFree_{*this, "body/mover_predict", {}, hasFree_};
    Pass predictJointed_{*this, "body/jointed_predict", angular_, hasJointed_};
    Pass predictLoose_{*this, "body/mover_predict", {{"LOOSE", "1"}}, hasLoose_};
    Pass clear_{*this, "body/impulse_clear", {}, onParticles_};
    Pass sumWarm_{*this, "body/impulse_sum", warm_, hasFree_ || hasJointed_};
    Pass solveFreeWarm_{*this, "body/body_solve", warm_, hasFree_};
    Pass solveJointedWarm_{*this, "body/jointed_solve", with(angular_, "WARM_START"), hasJointed_};
    Pass solveLooseWarm_{*this, "body/loose_solve", warm_, hasLoose_};
    Pass sum_{*this, "body/impulse_sum", onParticle_, hasFree_ || hasJointed_};
    Pass solveFree_{*this, "body/body_solve", {}, hasFree_};
    Pass solveFreeAgain_{*this, "body/body_solve", {{"AGAIN", "1"}}, hasFree_&& stacks_};
    Pass solveJointed_{*this, "body/jointed_solve", jointed_, hasJointed_};
    Pass solveLoose_{*this, "body/loose_solve", onParticle_, hasLoose_};
    Pass integrateFree_{*this, "body/mover_integrate", {}, hasFree_};
    Pass integrateJointed_{*this, "body/jointed_integrate", {}, hasJointed_};
    Pass integrateLoose_{*this, "body/mover_integrate", {{"LOOSE", "1"}}, hasLoose_};
    Pass place_{*this, "body/particle_position", {}, solves_};
};

}  // namespace knuckle
