#include "app/states/states_file.h"

#include <fmt/format.h>

#include <utility>

#include "app/scene/scene_document.h"

namespace knuckle {

namespace {

constexpr const char* RUN = "run";

std::string runText(const Scene& scene, const RunFacts& facts)
{
    Json changes = Json::object(), bodies = Json::array();
    for (const Override& change : facts.source.changes) changes[change.path] = change.value;
    for (const Body& body : scene.world.bodies) bodies.push_back(body.name);
    const Json run = {{"fingerprint", facts.fingerprint.json()},
                      {"scene", facts.sceneName},
                      {"file", facts.source.file},
                      {"set", changes},
                      {"document", parseJson(facts.document, facts.source.file)},
                      {"fps", facts.framesPerSecond},
                      {"stepsPerFrame", facts.stepsPerFrame},
                      {"diameter", facts.diameter},
                      {"particles", facts.particles},
                      {"bodies", bodies}};
    return run.dump(1);
}

RunFacts readFacts(const BlockReader& file)
{
    if (!file.has(RUN)) file.refuse("has no block \"run\": it is no file of states");
    try {
        const Json run = parseJson(file.readText(RUN), file.path());
        RunFacts facts{.fingerprint = RunFingerprint::read(run.at("fingerprint"), file.path()),
                       .source = {run.at("file"), {}},
                       .sceneName = run.at("scene"),
                       .framesPerSecond = run.at("fps"),
                       .stepsPerFrame = run.at("stepsPerFrame"),
                       .particles = run.at("particles"),
                       .bodies = run.at("bodies").size(),
                       .diameter = run.at("diameter"),
                       .document = run.contains("document") ? run["document"].dump() : ""};
        for (const auto& [path, value] : run.at("set").items()) facts.source.changes.push_back({path, value});
        return facts;
    } catch (const Json::exception& error) {
        file.refuse(fmt::format("its block \"run\" is not as this program writes it ({})", error.what()));
    }
}

}  // namespace

RunFacts factsOf(const Scene& scene, const Gpu& gpu, SceneSource source)
{
    return {.fingerprint = fingerprintOf(scene, gpu),
            .source = std::move(source),
            .sceneName = scene.name,
            .framesPerSecond = scene.framesPerSecond,
            .stepsPerFrame = scene.stepsPerFrame,
            .particles = scene.world.particles.size(),
            .bodies = scene.world.bodies.size(),
            .diameter = scene.world.diameter(),
            .document = scene.document};
}

bool haveSameCamera(const Scene& scene, const RunFacts& facts)
{
    if (facts.document.empty()) return false;
    const auto cameras = [](const std::string& document, const std::string& file) {
        const Json root = storedSceneDocument(file, document).file.root;
        const Json& only = root["render"]["camera"];
        return Json::array(
            {root["camera"], root["cameras"], root["shots"], only, only == "turntable" ? root["duration"] : Json()});
    };
    return cameras(facts.document, facts.source.file) == cameras(scene.document, scene.file);
}

StatesWriter::StatesWriter(const std::string& path, const Scene& scene, const RunFacts& facts)
    : coding_(scene.world), file_(path)
{
    file_.add(packText(RUN, runText(scene, facts)));
    add(coding_.packBodies());
}

void StatesWriter::add(const std::vector<std::string>& blocks)
{
    for (const std::string& block : blocks) file_.add(block);
}

void StatesWriter::addFrame(uint64_t frame, const ViewState& view)
{
    add(coding_.pack(frame, view));
}

void StatesWriter::addState(const RunState& state)
{
    add(packState(state));
}

void StatesWriter::addCamera(uint64_t frame, const RendererState& camera)
{
    add(packCamera(frame, camera));
}

StatesFile::StatesFile(const std::string& path)
    : file_(path), facts_(readFacts(file_)), frames_(framesOf(file_)), states_(statesOf(file_))
{
}

}  // namespace knuckle
