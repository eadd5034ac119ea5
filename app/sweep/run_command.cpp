#include <fmt/format.h>

#include "app/files/assets.h"
#include "app/film/film_outputs.h"
#include "app/sweep/child.h"
#include "app/sweep/sweep.h"

namespace knuckle {

std::vector<std::string> runCommand(const Sweep& sweep, const SweepRun& run, const CommonOptions& common)
{
    const SweepPlan& plan = sweep.plan;
    const RunFolder folder = sweep.folderOf(run);
    std::vector<std::string> words{ownProgram(), "--device", common.device};
    const auto add = [&words](std::initializer_list<std::string> more) { words.insert(words.end(), more); };
    if (!common.shaderFolder.empty()) add({"--shaders", common.shaderFolder});
    add({"render"});
    if (!plan.scene.empty()) add({findAsset(plan.scene)});
    if (!plan.states.empty()) add({"--from", plan.states});
    for (const Override& change : plan.changes) add({"--set", change.path + "=" + change.value.dump()});
    for (size_t k = 0; k < plan.fields.size(); ++k) add({"--set", plan.fields[k].path + "=" + run.values[k].dump()});
    add({"-o", folder.file(plan.output)});
    if (!run.frames.empty()) add({"--frames", run.frames});
    else if (plan.isStill()) add({"--frames", "last"});
    for (const auto& [kind, name] : plan.exports) add({"--export", kind + "=" + folder.file(name)});
    if (!plan.simulates()) {
        if (!isFilm(plan.output)) add({"--skip-existing"});
        return words;
    }
    if (!plan.bodies.empty()) add({"--export", "bodies=" + folder.bodies()});
    add({"--stats", folder.stats(), "--hash", "--checkpoint", fmt::format("{}", plan.checkpointSeconds), "--resume"});
    return words;
}

}  // namespace knuckle
