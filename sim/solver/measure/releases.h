#pragma once

#include "sim/solver/measure/state.h"

namespace knuckle {

/// A body that was let go, as the solver notes it.
struct LetGo {
    uint32_t body = 0;
    uint32_t substep = 0;              ///< The first in which it responded, from 0.
    Vector3f velocity{0, 0, 0};        ///< Just before [m/s].
    Vector3f change{0, 0, 0};          ///< In that substep, beyond what gravity and contacts give [m/s].
    Vector3f changeByJoints{0, 0, 0};  ///< The part of that which its joints gave.
    float changeByContacts = 0.0f;     ///< Change of speed by contacts [m/s].
};

/// The bodies of an object that were let go at one time, and how smoothly.
struct ReleaseFigures {
    uint32_t object = NO_INDEX;
    double time = 0.0;  ///< [s]
    uint32_t bodies = 0;
    double momentum = 0.0;        ///< Sum of m |v| before [kg m/s].
    double momentumChange = 0.0;  ///< Of the sum of all, beyond what gravity, contacts and joints give [kg m/s].
    float fastest = 0.0f;         ///< Speed of the fastest body before [m/s].
    /// Of a body's velocity, beyond what gravity gives, and beyond what contacts and joints to held bodies give,
    /// including those of other bodies as far as joints may have passed it on [m/s].
    float worstBodyChange = 0.0f;
    float worstGap = 0.0f;  ///< Of the object's joints at the end of that step and the nine after it [m].
};

/// Collects them while a world is simulated.
class ReleaseLog {
public:
    explicit ReleaseLog(const World& world) : world_(world), known_(world.bodies.size()) {}

    /// After each step. @param gone all that were let go so far.
    void add(const std::vector<LetGo>& gone);
    /// Whether addGaps() is to follow.
    bool wantsGaps() const;
    void addGaps(const ParticleState& particles, const std::vector<BodyState>& bodies);
    /// In order of time.
    std::vector<ReleaseFigures> figures() const;

private:
    static constexpr uint32_t STEPS = 10;

    struct Entry {
        ReleaseFigures figures;
        uint32_t stepsLeft = STEPS;
    };

    const World& world_;
    std::vector<bool> known_;  ///< Per body.
    std::vector<Entry> entries_;
};

}  // namespace knuckle
