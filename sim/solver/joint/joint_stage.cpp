#include "sim/solver/joint/joint_stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "shared/drive_types.h"
#include "shared/joint_records.h"
#include "sim/solver/drive/drive_stage.h"
#include "sim/solver/drive/motor_stage.h"
#include "sim/solver/loop_rounds.h"
#include "sim/solver/pack.h"

namespace knuckle {

namespace {

constexpr const char* KIND = "joint";

bool tears(const World& world)
{
    return std::ranges::any_of(world.joints, [](const Joint& joint) { return joint.strength.tears(); });
}

bool letsGo(const World& world)
{
    return std::ranges::any_of(world.joints, [](const Joint& joint) { return std::isfinite(joint.strength.time); });
}

bool drives(const World& world)
{
    return DriveStage::isNeeded(world) || MotorStage::isNeeded(world);
}

bool isLimited(const World& world, const JointTrees::Joint& joint)
{
    return joint.joint != NO_INDEX && world.joints[joint.joint].limits.any();
}

/// The two bodies that a joint keeps from touching; for half of a universal joint, those beyond the cross.
gpu::uvec2 partedBy(const World& world, const JointTrees::Joint& joint)
{
    const auto past = [&](uint32_t body, uint32_t from) {
        if (body == NO_INDEX || !world.bodies[body].isCross) return body;
        for (const Joint& other : world.joints) {
            if (other.child == body && other.parent != from) return other.parent;
            if (other.parent == body && other.child != from) return other.child;
        }
        return body;
    };
    const uint32_t a = past(joint.body, joint.parent), b = past(joint.parent, joint.body);
    return b == NO_INDEX ? gpu::uvec2{a, a} : gpu::uvec2{a, b};
}

/// Short trees need only one elimination, whatever hangs on them: pairs of 50,000 : 1 swing with gaps below 0.05 % of a
/// diameter.
bool hasLongTree(const JointTrees& trees)
{
    constexpr uint32_t SHORT = 3;
    const auto isLong = [](const JointTrees::Tree& tree) { return tree.end - tree.first > SHORT; };
    return std::ranges::any_of(trees.trees, isLong);
}

/// Rounds of loops for each body of a tree: up with its children, down, and what limits and long trees look at.
constexpr uint64_t ROUNDS = 8;

bool hasRow(const World& world, uint32_t body)
{
    return body != NO_INDEX && !neverResponds(world.bodies[body]);
}

Defines loopVariant(const StageSetup& setup)
{
    return definesOf({{"ANGULAR", setup.rows.hasAngular()}, {"LIMITS", hasLimits(setup.world)}});
}

Defines solveVariant(const StageSetup& setup, bool loops, bool again)
{
    Defines variant = definesOf({{"LOOPS", loops}, {"TURNS", again}, {"SHORT_TREES", !loops && !again}});
    const Defines common = loopVariant(setup);
    variant.insert(variant.end(), common.begin(), common.end());
    return variant;
}

Defines factorVariant(const StageSetup& setup, bool loops, bool again)
{
    return definesOf({{"SHORT_TREES", !loops && !again},
                      {"RESPONSES", !setup.world.strands.empty()},
                      {"LIMITS", hasLimits(setup.world)},
                      {"DRIVES", drives(setup.world)}});
}

}  // namespace

void JointStage::reserveRows(RowPlan& rows, const World& world, const Layout& layout)
{
    for (const JointTrees::Joint& joint : layout.jointTrees.all()) {
        const auto reserve = [&](uint32_t body, const Vector3f& arm) {
            if (joint.freedom == JOINT_BALL && !isLimited(world, joint)) rows.reserve(KIND, body, arm);
            else rows.reserveAngular(KIND, body, arm);
        };
        if (joint.freedom == JOINT_NONE) continue;
        reserve(joint.body, joint.side.arm);
        if (hasRow(world, joint.parent)) reserve(joint.parent, joint.parentSide.arm);
    }
}

JointStage::JointStage(const StageSetup& setup)
    : parameters_(setup.parameters),
      needed_(setup.world.settings.solver == SolverKind::Impulse && !setup.layout.jointTrees.trees.empty()),
      shared_(setup.world.settings.solver == SolverKind::Impulse && !setup.layout.sharedParticles.empty()),
      hasLoops_(needed_ && !setup.layout.jointTrees.loops.empty()), hasLimits_(needed_ && hasLimits(setup.world)),
      drives_(needed_ && drives(setup.world)), tears_(needed_ && tears(setup.world)),
      again_(needed_ && (hasLimits_ || drives_ || hasLongTree(setup.layout.jointTrees))),
      loopPasses_(setup.layout.jointTrees, setup.gpu.limits().loopRounds),
      variant_(solveVariant(setup, hasLoops_, again_)), loopVariant_(loopVariant(setup)),
      factorVariant_(factorVariant(setup, hasLoops_, again_)), againVariant_(with(factorVariant_, "AGAIN")),
      rowVariant_(definesOf({{"ANGULAR", setup.rows.hasAngular()}})),
      tearVariant_(letsGo(setup.world) ? with(rowVariant_, "LETS_GO") : rowVariant_)
{
}

void JointStage::upload(const StageSetup& setup)
{
    const Layout& layout = setup.layout;
    sharedParticles = {"sharedParticles", std::span<const uint32_t>(layout.sharedParticles)};
    setup.parameters.sharedCount = static_cast<uint32_t>(layout.sharedParticles.size());
    uploadTrees(setup);
    uploadLimits(setup);
    uploadStrengths(setup);
}

void JointStage::uploadTrees(const StageSetup& setup)
{
    const JointTrees& trees = setup.layout.jointTrees;
    if (needed_) {
        const uint64_t bodies = trees.trees.front().end - trees.trees.front().first;
        const std::string what = fmt::format("an object of {} joined bodies", bodies);
        checkLoopRounds(setup.gpu, ROUNDS * bodies, what);
        checkLoopRounds(setup.gpu, loopPasses_.leastRounds, what + ", some of them in rings,");
    }
    const std::vector<uint32_t> reserved = setup.rows.rowsOf(KIND);
    size_t next = 0;
    std::vector<gpu::uvec4> ranges;
    std::vector<gpu::Joint> infos;
    std::vector<uint32_t> freedoms;
    const auto loops = static_cast<uint32_t>(trees.joints.size());
    std::vector<gpu::vec4> places;
    for (const JointTrees::Tree& tree : trees.trees)
        ranges.push_back({tree.first, tree.end, loops + tree.firstLoop, loops + tree.loopEnd});
    for (const JointTrees::Joint& joint : trees.all()) {
        freedoms.push_back(joint.freedom);
        const bool held = joint.freedom != JOINT_NONE;
        const uint32_t row = held ? reserved[next++] : NO_INDEX;
        const uint32_t parentRow = held && hasRow(setup.world, joint.parent) ? reserved[next++] : NO_INDEX;
        infos.push_back({joint.body, joint.parent, joint.bodyJoint, joint.parentJoint, row, parentRow, joint.firstChild,
                         joint.childEnd});
        places.push_back(pack(joint.side.arm, 0));
        places.push_back(pack(joint.parentSide.arm, 0));
        places.push_back(pack(joint.side.frame));
        places.push_back(pack(joint.parentSide.frame));
    }
    jointTrees = {"jointTrees", std::span<const gpu::uvec4>(ranges)};
    jointInfo = {"jointInfo", std::span<const gpu::Joint>(infos)};
    jointFreedoms = {"jointFreedoms", std::span<const uint32_t>(freedoms)};
    jointPlaces = {"jointPlaces", std::span<const gpu::vec4>(places)};
    jointFactors = {"jointFactors", JOINT_FACTOR_TEXELS * trees.joints.size()};
    rootFactors = {"rootFactors", ROOT_FACTOR_TEXELS * trees.joints.size()};
    treeTurns = {"treeTurns", trees.trees.size()};
    jointInertias = {"jointInertias", JOINT_INERTIA_TEXELS * trees.joints.size()};
    jointSweeps = {"jointSweeps", JOINT_SWEEP_TEXELS * trees.joints.size()};
    loopFactors = {"loopFactors", LOOP_FACTOR_TEXELS * trees.loops.size()};
    loopPass = {"loopPass", trees.trees.size()};
    loopSearches = {"loopSearches", LOOP_SEARCH_TEXELS * trees.loops.size()};
    loopPulls = {"loopPulls", hasLoops_ ? 2 * trees.joints.size() : 0};
    bodyResponses = {"bodyResponses", BODY_RESPONSE_TEXELS * size_t{setup.layout.bodyCount}};
    bodyResponses.clear();
    driveStiffness = {"driveStiffness", drives_ ? DRIVE_STIFFNESS_TEXELS * trees.joints.size() : 0};
    driveStiffness.clear();
    setup.parameters.treeJointCount = static_cast<uint32_t>(trees.joints.size());
    setup.parameters.jointTreeCount = static_cast<uint32_t>(ranges.size());
}

void JointStage::uploadLimits(const StageSetup& setup)
{
    constexpr float NONE = 4.0f;  // more than half a turn
    std::vector<gpu::JointRange> limits;
    if (hasLimits_) {
        for (const JointTrees::Joint& joint : setup.layout.jointTrees.all()) {
            const TurnLimits l = joint.joint == NO_INDEX ? TurnLimits{} : setup.world.joints[joint.joint].limits;
            const bool turns = l.twist.bounded(), swings = l.swing < TurnLimits{}.swing;
            limits.push_back({swings ? l.swing : NONE, turns ? l.twist.lowest : -NONE, turns ? l.twist.highest : NONE,
                              std::isinf(l.stiffness) ? 0.0f : l.stiffness});
        }
    }
    jointLimits = {"jointLimits", std::span<const gpu::JointRange>(limits)};
    jointLimitStates = {"jointLimitStates", JOINT_LIMIT_TEXELS * limits.size()};
    jointLimitStates.clear();
}

void JointStage::uploadStrengths(const StageSetup& setup)
{
    std::vector<gpu::uvec4> strengths;
    std::vector<gpu::uvec2> parted;
    std::vector<uint32_t> particles, releases;
    if (tears_) {
        for (const JointTrees::Joint& joint : setup.layout.jointTrees.all()) {
            const auto first = static_cast<uint32_t>(particles.size());
            particles.insert(particles.end(), joint.particles.begin(), joint.particles.end());
            const JointStrength strength = joint.joint == NO_INDEX ? JointStrength{}
                                                                   : setup.world.joints[joint.joint].strength;
            strengths.push_back({std::bit_cast<uint32_t>(strength.force), std::bit_cast<uint32_t>(strength.torque),
                                 first, static_cast<uint32_t>(particles.size())});
            parted.push_back(partedBy(setup.world, joint));
            releases.push_back(setup.world.settings.substepAt(strength.time));
        }
    }
    jointStrengths = {"jointStrengths", std::span<const gpu::uvec4>(strengths)};
    jointFilters = {"jointFilters", std::span<const gpu::uvec2>(parted)};
    jointParticles = {"jointParticles", std::span<const uint32_t>(particles)};
    jointReleases = {"jointReleases", std::span<const uint32_t>(releases)};
    jointLoads = {"jointLoads", JOINT_LOAD_TEXELS * strengths.size()};
    jointLoads.clear();
}

void JointStage::addBuffers(BufferTable& table)
{
    table.addFloatStructs(Lifetime::Constant, jointLimits);
    table.add(Lifetime::Constant, sharedParticles, jointTrees, jointInfo, jointPlaces, jointStrengths, jointParticles,
              jointFilters, jointReleases);
    table.add(Lifetime::State, jointFreedoms, jointLimitStates, jointLoads, bodyResponses, driveStiffness);
    table.add(Lifetime::State, loopPass);  // zero after the last
    table.add(Lifetime::Scratch, jointFactors, rootFactors, treeTurns, jointInertias, jointSweeps, loopFactors,
              loopSearches, loopPulls);
}

void JointStage::recordLoops(Recorder& recorder, const Pass& pass, uint32_t times) const
{
    for (uint32_t k = 0; hasLoops_ && k < times; ++k) recorder.groups(pass, treeGroups());
}

void JointStage::factor(Recorder& recorder) const
{
    recorder.groups(factor_, treeGroups());
    recordLoops(recorder, factorLoops_, loopPasses_.passes);
}

void JointStage::factorAgain(Recorder& recorder, bool last) const
{
    if (!again_) return;
    recorder.groups(last && hasLimits_ ? refactorLast_ : refactor_, treeGroups());
    if (hasLimits_) recordLoops(recorder, factorLoops_, loopPasses_.passes);
}

void JointStage::solve(Recorder& recorder, bool first) const
{
    recorder.groups(first ? solveFirst_ : solve_, treeGroups());
    recordLoops(recorder, solveLoops_, loopPasses_.series);
}

void JointStage::tear(Recorder& recorder) const
{
    if (tears_) recorder.groups(tear_, treeGroups());
}

std::vector<bool> JointStage::tornParticles(const World& world) const
{
    if (!tears_) return {};
    std::vector<bool> torn(world.particles.size(), false);
    const std::vector<gpu::uvec4> strengths = jointStrengths.download();
    const std::vector<uint32_t> freedoms = jointFreedoms.download();
    const std::vector<uint32_t> particles = jointParticles.download();
    for (size_t k = 0; k < freedoms.size(); ++k)
        if (freedoms[k] == JOINT_NONE)
            for (uint32_t i = strengths[k].z; i < strengths[k].w; ++i) torn[particles[i]] = true;
    return torn;
}

uint32_t JointStage::treeGroups() const
{
    return needed_ ? (parameters_.jointTreeCount + TREE_GROUP_SIZE - 1) / TREE_GROUP_SIZE : 0;
}

void JointStage::placeParticles(Recorder& recorder) const
{
    recorder.perElement(place_, parameters_.sharedCount);
}

}  // namespace knuckle
