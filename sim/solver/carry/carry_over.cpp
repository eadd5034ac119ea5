#include "sim/solver/carry/carry_over.h"

#include <array>
#include <stdexcept>

#include "shared/drive_types.h"
#include "shared/joint_records.h"
#include "shared/motor_types.h"
#include "sim/solver/carry/carrying.h"

namespace knuckle {

namespace {

/// A buffer whose elements are carried over as they are.
struct Carried {
    const char* name;
    Per kind;
    size_t words;       ///< Of an element.
    int timePower = 0;  ///< Its values are proportional to this power of the substep.
};

constexpr std::array CARRIED{
    Carried{"positions", Per::Particle, 4},
    Carried{"velocities", Per::Particle, 4},
    Carried{"fluidPasts", Per::Particle, 4},
    Carried{"fluidForms", Per::Particle, 1},
    Carried{"moverCentres", Per::Mover, 4},
    Carried{"moverRotations", Per::Mover, 4},
    Carried{"moverMoves", Per::Mover, 4},
    Carried{"moverRotationDeltas", Per::Mover, 4},
    Carried{"moverVelocities", Per::Field, 4},
    Carried{"oldMoverVelocities", Per::Field, 4},
    Carried{"oldMoverMoves", Per::Field, 4, 1},
    Carried{"moverImpulses", Per::Field, 4, 2},
    Carried{"moverChanges", Per::Field, 4},
    Carried{"rowImpulses", Per::Row, 4, 2},
    Carried{"rowAngularImpulses", Per::Row, 4, 2},
    Carried{"jointLimitStates", Per::Joint, 4 * JOINT_LIMIT_TEXELS},
    Carried{"jointLoads", Per::Joint, 4 * JOINT_LOAD_TEXELS},
    Carried{"bodyResponses", Per::Body, 4 * BODY_RESPONSE_TEXELS},
    Carried{"releaseNotes", Per::Held, 12},
    Carried{"clipBodyTurns", Per::Animated, 4},
    Carried{"clipBodyPlaces", Per::Animated, 8},
    Carried{"driveLevels", Per::Animated, 1},
    Carried{"driveHits", Per::Animated, 4},
    Carried{"catchOffsets", Per::Animated, 8},
    Carried{"driveStates", Per::JointDrive, 4 * DRIVE_STATE_TEXELS},
    Carried{"pinStates", Per::Pin, 4 * PIN_STATE_TEXELS},
    Carried{"pinsGiven", Per::Pin, 4 * PIN_GIVEN_TEXELS},
    Carried{"motorStates", Per::Motor, 4 * MOTOR_STATE_TEXELS},
    Carried{"gearStates", Per::GearedHinge, 4 * GEAR_STATE_TEXELS},
    Carried{"driveStiffness", Per::TreeJoint, 4 * DRIVE_STIFFNESS_TEXELS},
    Carried{"clusterRotations", Per::Cluster, 4},
    Carried{"clusterRests", Per::Cluster, 12},
    Carried{"distanceStates", Per::Distance, 4},
    Carried{"particleAges", Per::Particle, 1},
    Carried{"contactForces", Per::Particle, 1},
};

/// What carryContacts(), carryReleases(), carryCounted() and carryFoam() do.
constexpr std::array BY_HAND{
    "assemblyState", "bodyReleases",  "colliderImpulses", "colliderMeans", "colliderPairs", "countersBlock",
    "dispatches",    "filterBits",    "fluidTotals",      "foamMoves",     "foamPlaces",    "foamRing",
    "jointFreedoms", "limpSubsteps",  "listStarts",       "moverStates",   "pairImpulses",  "pairMeans",
    "pairs",         "particleLinks", "poolInactive",     "poolOrder",     "puppetStates",
};

/// What begins anew: the next search, step or count of calm steps fills it. Clips say where colliders are, the world
/// what `step` holds; what fluids may gain is found again; a step leaves its passes over loops of joints at none.
constexpr std::array ANEW{
    "assemblyCalm",    "assemblyNext",      "bodyActing",      "calmCentres",     "calmRotations",
    "cellCounts",      "cellSums",          "colliderAheads",  "colliderArms",    "colliderFounds",
    "colliderMoves",   "colliderPlaces",    "colliderSides",   "emitterStates",   "fluidCellCounts",
    "fluidCellSums",   "fluidEnergyLimits", "foamSums",        "islandsWoken",    "lastCollision",
    "linkPulls",       "listCounts",        "listSums",        "loopPass",        "oldMoves",
    "oldVelocities",   "pairArms",          "pairReferences",  "pairSides",       "poolSums",
    "releaseImpulses", "searchCentres",     "searchPositions", "searchRotations", "step",
};

void carry(const Carrying& c, const Carried& rule)
{
    if (!c.has(rule.name)) return;
    const auto from = readState<float>(c.from, rule.name);
    auto to = readState<float>(c.to, rule.name);
    const auto scale = static_cast<float>(std::pow(c.substepRatio(), rule.timePower));
    const std::vector<uint32_t>& map = c.maps.of(rule.kind);
    for (size_t i = 0; i < map.size(); ++i) {
        if (map[i] == NO_INDEX || (i + 1) * rule.words > to.size()) continue;
        for (size_t k = 0; k < rule.words; ++k) {
            const float value = from.at(map[i] * rule.words + k);
            to[i * rule.words + k] = scale == 1.0f ? value : scale * value;
        }
    }
    writeState(c.to, rule.name, to);
}

}  // namespace

std::vector<std::string> carriedBuffers()
{
    std::vector<std::string> names(BY_HAND.begin(), BY_HAND.end());
    names.insert(names.end(), ANEW.begin(), ANEW.end());
    for (const Carried& rule : CARRIED) names.emplace_back(rule.name);
    return names;
}

StagesState carriedOver(const StagesOf& before, const StagesOf& after, const Counterparts& same, uint32_t substep)
{
    const StagesState from = before.stages.save();
    StagesState to = after.stages.save();
    const ElementMaps maps(before, after, same);
    const uint32_t earlier = readState<gpu::Counters>(from, "countersBlock").at(0).substep;
    const Carrying carrying{before, after, same, maps, from, to, earlier, substep};
    for (const Carried& rule : CARRIED) carry(carrying, rule);
    carryReleases(carrying);
    carryContacts(carrying);
    carryCounted(carrying);
    carryFoam(carrying);
    return to;
}

}  // namespace knuckle
