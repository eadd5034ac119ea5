#include "sim/solver/joint/gear_stage.h"

#include <map>

#include "shared/joint_records.h"

namespace knuckle {

namespace {

constexpr const char* KIND = "gear";

/// By joint of the world: its joint in the trees.
std::map<uint32_t, uint32_t> treeJoints(const JointTrees& trees)
{
    std::map<uint32_t, uint32_t> found;
    for (uint32_t k = 0; k < trees.joints.size(); ++k)
        if (trees.joints[k].joint != NO_INDEX) found.emplace(trees.joints[k].joint, k);
    return found;
}

}  // namespace

GearStage::GearStage(const StageSetup& setup)
    : parameters_(setup.parameters), move_{*this, "joint/gears/gear_move",
                                           definesOf({{"LIMITS", hasLimits(setup.world)}})}
{
}

bool GearStage::isNeeded(const World& world)
{
    return !world.gears.empty();
}

void GearStage::reserveRows(RowPlan& rows, const World& world, const Layout& layout)
{
    const auto joints = treeJoints(layout.jointTrees);
    for (const GearTrain& train : gearTrainsOf(world))
        for (const GearTrain::Hinge& hinge : train.hinges) {
            const JointTrees::Joint& joint = layout.jointTrees.joints[joints.at(hinge.joint)];
            rows.reserveAngular(KIND, joint.body);
            if (!neverResponds(world.bodies[joint.parent])) rows.reserveAngular(KIND, joint.parent);
        }
}

void GearStage::upload(const StageSetup& setup)
{
    const JointTrees& trees = setup.layout.jointTrees;
    const auto joints = treeJoints(trees);
    const std::vector<uint32_t> rows = setup.rows.rowsOf(KIND);
    std::vector<gpu::GearedHinge> hinges;
    std::vector<gpu::uvec2> trains;
    size_t next = 0;
    for (const GearTrain& train : gearTrainsOf(setup.world)) {
        const auto first = static_cast<uint32_t>(hinges.size());
        for (const GearTrain::Hinge& hinge : train.hinges) {
            const uint32_t k = joints.at(hinge.joint), row = rows[next++];
            const bool answers = !neverResponds(setup.world.bodies[trees.joints[k].parent]);
            gpu::GearedHinge packed{};
            packed.joint = k;
            packed.row = row;
            packed.parentRow = answers ? rows[next++] : NO_INDEX;
            packed.before = hinge.before == NO_INDEX ? NO_INDEX : first + hinge.before;
            packed.ratio = hinge.ratio;
            hinges.push_back(packed);
        }
        trains.push_back({first, static_cast<uint32_t>(hinges.size())});
    }
    setup.parameters.gearTrainCount = static_cast<uint32_t>(trains.size());
    gearTrains = {"gearTrains", std::span<const gpu::uvec2>(trains)};
    gearHinges = {"gearHinges", std::span<const gpu::GearedHinge>(hinges)};
    gearStates = {"gearStates", GEAR_STATE_TEXELS * hinges.size()};
    gearStates.clear();
    gearAsked = {"gearAsked", hinges.size()};
    std::vector<uint32_t> hingeOf(trees.joints.size(), NO_INDEX);
    for (uint32_t h = 0; h < hinges.size(); ++h) hingeOf[hinges[h].joint] = h;
    gearedHingeOf = {"gearedHingeOf", std::span<const uint32_t>(hingeOf)};
}

void GearStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, gearTrains, gearHinges, gearedHingeOf);
    table.add(Lifetime::State, gearStates);
    table.add(Lifetime::Scratch, gearAsked);
}

void GearStage::begin(Recorder& recorder) const
{
    recorder.perElement(begin_, parameters_.gearTrainCount);
}

void GearStage::solve(Recorder& recorder) const
{
    recorder.perElement(solve_, parameters_.gearTrainCount);
    recorder.groups(move_, (parameters_.jointTreeCount + TREE_GROUP_SIZE - 1) / TREE_GROUP_SIZE);
}

}  // namespace knuckle
