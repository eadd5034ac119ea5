#include "sim/rig/bodies/make_actor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "sim/base/errors.h"
#include "sim/base/short_list.h"
#include "sim/rig/bodies/articulate.h"
#include "sim/rig/bodies/bone_options.h"
#include "sim/rig/bodies/part_bodies.h"
#include "sim/rig/bodies/resolution.h"
#include "sim/rig/clips/clip_ranges.h"

namespace knuckle {

namespace {

constexpr uint32_t FEWEST = 800, MOST = 4000;  // particles by default
constexpr double CLOSE = 0.02;                 // of the wanted count
constexpr int ROUNDS = 14;
constexpr float THIN = 2.0f;  // particles across a limb

Actor actorOf(const Figure& figure, const Solid& solid, ActorOptions options, float diameter)
{
    options.voxels.diameter = diameter;
    return figure.model.isSplit ? partBodies(figure.model, solid, options) : articulate(figure, solid, options);
}

/// Thicknesses of limbs, which do not depend on roles that options give to bones.
std::vector<LimbThickness> thicknessesOf(const Figure& figure)
{
    return limbThicknesses(figure.wanted.empty() ? figure : readFigure(figure.model));
}

/// Nothing if not a single particle fits.
std::optional<Actor> actorIfAny(const Figure& figure, const Solid& solid, const ActorOptions& options, float diameter)
{
    try {
        return actorOf(figure, solid, options, diameter);
    } catch (const InputError&) {
        return std::nullopt;
    }
}

/// The number of particles at a diameter, whether a plan's bodies have room in them or not; a half if not a single one
/// fits.
double countAt(const Figure& figure, const Solid& solid, ActorOptions options, double diameter)
{
    options.plan = {};
    const std::optional<Actor> actor = actorIfAny(figure, solid, options, static_cast<float>(diameter));
    return actor ? static_cast<double>(actor->particles.size()) : 0.5;
}

/// Diameters that bracket the wanted count, as far as known.
class Bracket {
public:
    explicit Bracket(double wanted) : wanted_(wanted) {}

    void learn(double diameter, double count)
    {
        Point& side = count > wanted_ ? fine_ : coarse_;
        side.diameter = diameter;
        side.count = count;
    }
    /// The next diameter: from the last one by the cube of the diameter, or between two, alternately where the count
    /// should be reached and in the middle, since the count jumps as layers come and go.
    double next(double diameter, double count, int round) const
    {
        if (fine_.diameter == 0.0 || coarse_.diameter == 0.0) return diameter * std::cbrt(count / wanted_);
        if (round % 2 == 1) return std::sqrt(fine_.diameter * coarse_.diameter);
        const double above = std::log(fine_.count / wanted_), below = std::log(wanted_ / coarse_.count);
        return fine_.diameter * std::pow(coarse_.diameter / fine_.diameter, above / (above + below));
    }

private:
    struct Point {
        double diameter = 0.0, count = 0.0;  // 0: none known
    };
    double wanted_;
    Point fine_, coarse_;
};

/// @param diameter to begin with [m].
Actor actorOfCount(const Figure& figure, const Solid& solid, const ActorOptions& options, uint32_t wanted,
                   double diameter)
{
    Bracket bracket(wanted);
    std::optional<Actor> best;
    double bestError = std::numeric_limits<double>::infinity();
    for (int round = 0; round < ROUNDS && bestError > CLOSE * wanted; ++round) {
        std::optional<Actor> actor = actorIfAny(figure, solid, options, static_cast<float>(diameter));
        const double count = actor ? static_cast<double>(actor->particles.size())
                                   : countAt(figure, solid, options, diameter);
        const double error = std::abs(count - wanted);
        if (actor && error < bestError) {
            bestError = error;
            best = std::move(actor);
        }
        bracket.learn(diameter, count);
        diameter = bracket.next(diameter, count, round);
    }
    return best ? *best : actorOf(figure, solid, options, static_cast<float>(diameter));
}

/// Notes which limbs are less than two particles thick.
void noteThinLimbs(const Figure& figure, std::span<const LimbThickness> limbs, Actor& actor)
{
    std::vector<std::string> names;
    float thinnest = std::numeric_limits<float>::max();
    for (const LimbThickness& limb : limbs) {
        if (limb.thickness >= THIN * actor.diameter) continue;
        names.push_back(figure.model.bones[limb.bone].name);
        thinnest = std::min(thinnest, limb.thickness);
    }
    if (!names.empty())
        actor.notes.push_back(fmt::format("Less than two particles thick: {}; --diameter {:.2g} gives them two.",
                                          shortList(names), thinnest / THIN));
}

/// The number of particles at a diameter, estimated by volume from that at another.
double scaledCount(const Actor& actor, float diameter)
{
    return static_cast<double>(actor.particles.size()) * std::pow(double{actor.diameter} / diameter, 3);
}

/// An actor with limbs as many particles thick as FEWEST to MOST particles allow.
Actor actorByLimbs(const Figure& figure, const Solid& solid, const ActorOptions& options, float diameter)
{
    const Actor coarse = actorOf(figure, solid, options, 0.0f);
    if (scaledCount(coarse, diameter) > 2 * MOST) return actorOfCount(figure, solid, options, MOST, coarse.diameter);
    Actor actor = actorOf(figure, solid, options, diameter);
    const uint32_t count = static_cast<uint32_t>(actor.particles.size()), wanted = std::clamp(count, FEWEST, MOST);
    return wanted == count ? actor : actorOfCount(figure, solid, options, wanted, diameter);
}

}  // namespace

Actor makeActor(const Figure& figure, const ActorOptions& options)
{
    if (options.particleCount > options.voxels.particleLimit)
        throw std::logic_error(fmt::format("{} particles wanted for one model, at most {} are allowed: ask for fewer",
                                           options.particleCount, options.voxels.particleLimit));
    if (!figure.model.isSplit) checkBoneNames(figure.model, options.articulation);
    const Solid solid(figure.model.vertices, figure.model.triangles);
    const std::vector<LimbThickness> limbs = thicknessesOf(figure);
    const bool byLimbs = options.voxels.diameter == 0.0f && options.particleCount == 0 && !limbs.empty();
    ActorOptions first = options;
    if (options.particleCount > 0) first.plan = {};  // only its diameter counts, at which a plan may have no room
    Actor actor = byLimbs ? actorByLimbs(figure, solid, options, limbDiameter(limbs))
                          : actorOf(figure, solid, first, options.voxels.diameter);
    if (options.particleCount > 0) actor = actorOfCount(figure, solid, options, options.particleCount, actor.diameter);
    allow(actor, rangesInClips(figure, actor, options.articulation));
    noteThinLimbs(figure, limbs, actor);
    return actor;
}

Actor makeActor(const Model& model, const ActorOptions& options)
{
    return makeActor(readFigure(model, rolesWanted(model, options.articulation)), options);
}

}  // namespace knuckle
