#include "sim/solver/measure/releases.h"

#include <algorithm>
#include <map>

#include "sim/solver/measure/measure.h"

namespace knuckle {

void ReleaseLog::add(const std::vector<LetGo>& gone)
{
    const double substep = double{world_.settings.timeStep} / world_.settings.substeps;
    std::map<std::pair<uint32_t, uint32_t>, std::vector<const LetGo*>> together;  // by time and object
    for (const LetGo& one : gone) {
        if (known_[one.body]) continue;
        known_[one.body] = true;
        together[{one.substep, world_.bodies[one.body].object}].push_back(&one);
    }
    for (const auto& [when, bodies] : together) {
        ReleaseFigures figures;
        figures.object = when.second;
        figures.time = when.first * substep;
        figures.bodies = static_cast<uint32_t>(bodies.size());
        Eigen::Vector3d change = Eigen::Vector3d::Zero(), held = Eigen::Vector3d::Zero();
        double blow = 0.0;  // impulse from contacts and from the joints to what is still held [N s]
        for (const LetGo* one : bodies) {
            const double mass = world_.bodies[one->body].mass;
            blow += mass * one->changeByContacts;
            held += mass * one->changeByJoints.cast<double>();
            change += mass * (one->change - one->changeByJoints).cast<double>();
        }
        blow += held.norm();
        for (const LetGo* one : bodies) {
            const double mass = world_.bodies[one->body].mass;
            figures.momentum += mass * one->velocity.norm();
            figures.fastest = std::max(figures.fastest, one->velocity.norm());
            figures.worstBodyChange = std::max(figures.worstBodyChange,
                                               one->change.norm() - static_cast<float>(blow / mass));
        }
        figures.momentumChange = change.norm();
        entries_.push_back({figures});
    }
}

bool ReleaseLog::wantsGaps() const
{
    return std::ranges::any_of(entries_, [](const Entry& entry) { return entry.stepsLeft > 0; });
}

void ReleaseLog::addGaps(const ParticleState& particles, const std::vector<BodyState>& bodies)
{
    for (Entry& entry : entries_) {
        if (entry.stepsLeft == 0) continue;
        --entry.stepsLeft;
        const float gap = worstJointGap(world_, particles, bodies, world_.objects[entry.figures.object]);
        entry.figures.worstGap = std::max(entry.figures.worstGap, gap);
    }
}

std::vector<ReleaseFigures> ReleaseLog::figures() const
{
    std::vector<ReleaseFigures> all;
    for (const Entry& entry : entries_) all.push_back(entry.figures);
    return all;
}

}  // namespace knuckle
