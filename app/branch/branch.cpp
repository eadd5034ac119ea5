#include "app/branch/branch.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

#include "app/files/assets.h"
#include "app/json/json.h"
#include "app/run/counted.h"
#include "app/states/states_file.h"
#include "app/states/states_text.h"
#include "sim/base/fnv_hash.h"
#include "sim/solver/shown/shown_stage.h"
#include "sim/world/fingerprint/fingerprint.h"
#include "sim/world/match/start_world.h"

namespace knuckle {

namespace {

constexpr size_t NAMES_TOLD = 8;

/// Refuses a field of the scene's `start`.
[[noreturn]] void fail(const Scene& scene, const char* field, const std::string& message)
{
    failAt(scene.file, std::string("/start/") + field, message);
}

uint64_t frameOf(const Scene& scene, const StatesFile& states)
{
    std::vector<uint64_t> frames;
    std::ranges::set_union(states.frames(), states.states(), std::back_inserter(frames));
    if (states.states().empty()) fail(scene, "from", states.path() + " has no whole state; record it again");
    const uint64_t frame = scene.start->frame == 0 ? frames.back() : scene.start->frame;
    if (!std::ranges::binary_search(frames, frame))
        fail(scene, "frame", fmt::format("{} has frames {}; choose among them", states.path(), framesText(frames)));
    if (states.states().front() > frame)
        fail(scene, "frame",
             fmt::format("{} has no whole state up to frame {}, the first is of frame {}; choose that or a later one",
                         states.path(), frame, states.states().front()));
    if (scene.frameCount() < frame)
        failAt(scene.file, "/duration",
               fmt::format("{:g} s end with frame {}, before frame {}, with which the scene begins; raise it",
                           scene.duration, scene.frameCount(), frame));
    return frame;
}

void requireSameScale(const Scene& scene, const StatesFile& states)
{
    const RunFacts& facts = states.facts();
    if (facts.framesPerSecond != scene.framesPerSecond)
        fail(scene, "from",
             fmt::format("{} has {} frames a second, the scene {}; set /fps to {}", states.path(),
                         facts.framesPerSecond, scene.framesPerSecond, facts.framesPerSecond));
    if (static_cast<float>(facts.diameter) != scene.world.diameter())
        fail(scene, "from",
             fmt::format("{} has particles of {:g} m, the scene of {:g} m; set /diameter to {:g}", states.path(),
                         facts.diameter, scene.world.diameter(), facts.diameter));
}

/// Frames of both are counted in steps.
void requireFullSpeed(const Scene& scene, const StatesFile& states)
{
    const RunFacts& facts = states.facts();
    if (!scene.clock.isEven())
        failAt(scene.file, "/shots",
               "a scene with `start` has no slow or fast motion; let `timeScale` be 1 in all of them");
    if (!facts.document.empty() && !storedClock(facts.source.file, facts.document, facts.stepsPerFrame).isEven())
        fail(scene, "from",
             fmt::format("{} is of a film with slow or fast motion, from which nothing goes on; record it without: "
                         "--set 'shots=[]'",
                         states.path()));
}

/// The scene of the states, as it was in their run.
World worldOf(const Scene& scene, const StatesFile& states)
{
    const RunFacts& facts = states.facts();
    if (facts.document.empty())
        fail(scene, "from",
             states.path() + " does not hold the scene of its run, as this version writes it; record it "
                             "again");
    Scene other = loadStoredScene(findAsset(facts.source.file), facts.document);
    if (hashText(fingerprint(other.world)) != facts.fingerprint.world)
        fail(scene, "from",
             fmt::format("{} is of a world that {} and its models do not make any more; record it again", states.path(),
                         facts.source.file));
    return std::move(other.world);
}

template <typename Things>
bool haveSameNames(const Things& one, const Things& other)
{
    return std::ranges::equal(one, other, [](const auto& a, const auto& b) { return a.name == b.name; });
}

/// Whether all by which counterparts() knows things again has the same names in both.
bool haveSameNames(const World& one, const World& other)
{
    return haveSameNames(one.objects, other.objects) && haveSameNames(one.bodies, other.bodies) &&
           haveSameNames(one.looseGroups, other.looseGroups) && haveSameNames(one.materials, other.materials);
}

/// What a scene shows of particles goes on as well.
void requireShown(const Scene& scene, const ShownQuantities& stored, const StatesFile& states)
{
    const ShownQuantities& shown = scene.world.shown;
    const bool lacksAges = shown.ages && !stored.ages;
    if (lacksAges || (shown.contactForces && !stored.contactForces))
        fail(scene, "from",
             fmt::format("{} has no {}, which /render/colorBy asks for; record it with the same, or choose another",
                         states.path(), lacksAges ? "ages" : "forces of contacts"));
}

void requireSameKind(const Scene& scene, const World& other, const StatesFile& states)
{
    for (const World* world : {&scene.world, &other})
        if (world->settings.solver == SolverKind::Paper)
            fail(scene, "from",
                 fmt::format("{} is of another world than the scene, and the paper's solver cannot take "
                             "one over into another; use the solver \"default\" in both",
                             states.path()));
    if (scene.world.fluidCount > 0 && other.fluidCount > 0 && scene.world.fluidSpacing != other.fluidSpacing)
        failAt(scene.file, "/fluidSpacing",
               fmt::format("{} has fluids of {:g} diameters; take the same", states.path(),
                           other.fluidSpacing / other.diameter()));
}

/// "a, b and 3 more".
std::string namesText(const std::vector<std::string>& names)
{
    if (names.size() <= NAMES_TOLD) return fmt::format("{}", fmt::join(names, ", "));
    const std::vector<std::string> first(names.begin(), names.begin() + NAMES_TOLD);
    return fmt::format("{} and {} more", fmt::join(first, ", "), names.size() - NAMES_TOLD);
}

}  // namespace

std::string Branch::note() const
{
    std::string text = fmt::format("goes on from {}, frame {}: ", file, frame);
    if (!other) return text + "all as it was";
    const auto kept = [](uint32_t index) { return index != NO_INDEX; };
    const auto bodies = static_cast<uint64_t>(std::ranges::count_if(same.bodies, kept));
    uint64_t loose = 0;
    for (size_t p = 0; p < begin.solidCount(); ++p)
        loose += kept(same.particles[p]) && begin.particles[p].body == NO_INDEX ? 1 : 0;
    std::vector<std::string> parts;
    if (bodies > 0) parts.push_back(counted(bodies, "body", "bodies"));
    if (loose > 0) parts.push_back(counted(loose, "loose particle"));
    if (fluid.kept > 0) parts.push_back(counted(fluid.kept, "particle") + " of fluid");
    text += parts.empty() ? "nothing is as it was" : fmt::format("{} as they were", fmt::join(parts, " and "));
    if (fluid.added > 0) text += "; " + counted(fluid.added, "particle") + " of fluid new at their start";
    if (fluid.lost > 0) text += "; " + counted(fluid.lost, "particle") + " of fluid gone";
    if (!same.added.empty()) text += "; new: " + namesText(same.added);
    if (!same.gone.empty()) text += "; gone: " + namesText(same.gone);
    const auto isNumber = [](const std::string& name) { return name.starts_with("object_"); };
    if (std::ranges::any_of(same.added, isNumber) && std::ranges::any_of(same.gone, isNumber))
        text += "; objects without a name go by their number, so put new ones at the end";
    return text;
}

std::unique_ptr<Branch> openBranch(const Scene& scene)
{
    if (!scene.start) return nullptr;
    if (!std::filesystem::is_regular_file(scene.start->file))
        fail(scene, "from", fmt::format("there is no file {}; paths are relative to the scene", scene.start->file));
    const StatesFile states(scene.start->file);
    const RunFacts& facts = states.facts();
    requireSameScale(scene, states);
    requireFullSpeed(scene, states);
    auto branch = std::make_unique<Branch>();
    branch->file = states.path();
    branch->fingerprint = facts.fingerprint;
    branch->frame = frameOf(scene, states);
    branch->stepsPerFrame = facts.stepsPerFrame;
    branch->keepsCamera = haveSameCamera(scene, facts);
    const std::vector<uint64_t>& whole = states.states();
    branch->state = unpackState(states.blocks(), *std::prev(std::ranges::upper_bound(whole, branch->frame)));
    auto other = std::make_unique<World>(worldOf(scene, states));
    requireShown(scene, other->shown, states);
    // A fingerprint has no names.
    const bool same = facts.fingerprint.world == hashText(fingerprint(scene.world)) &&
                      haveSameNames(*other, scene.world);
    if (same && facts.stepsPerFrame == scene.stepsPerFrame) {
        leaveOutUnshown(branch->state.solver.stages, scene.world.shown);
        return branch;
    }
    branch->other = std::move(other);
    requireSameKind(scene, *branch->other, states);
    branch->same = counterparts(*branch->other, scene.world);
    branch->begin = atTime(scene.world, scene.timeOf(branch->frame));
    branch->fluid = branchedFluid(states, branch->frame, branch->state, *branch->other, branch->begin, branch->same);
    if (branch->fluid.drainedForGood)
        fail(scene, "frame",
             fmt::format("some of the fluid has drained away by frame {}, and the scene has no drain; keep one, out of "
                         "the way if nothing is to drain any more",
                         branch->frame));
    return branch;
}

}  // namespace knuckle
