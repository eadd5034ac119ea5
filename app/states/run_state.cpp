#include "app/states/run_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <span>
#include <utility>

#include "app/json/json.h"

namespace knuckle {

namespace {

constexpr std::string_view SOLVER = "solver/", RENDERER = "renderer/", BETWEEN = "between/";

std::string stateBlock(uint64_t frame, std::string_view part)
{
    return fmt::format("state {}/{}", frame, part);
}

std::string cameraBlock(uint64_t frame, std::string_view part)
{
    return fmt::format("camera {}/{}", frame, part);
}

/// Begins the names of a renderer's buffers. @param index among the cameras.
std::string rendererPart(size_t index)
{
    return index == 0 ? std::string(RENDERER) : fmt::format("renderer {}/", index);
}

/// @param folder begins the names of the blocks.
void packBuffers(const std::string& folder, const BufferState& buffers, std::vector<std::string>& blocks)
{
    for (const auto& [name, bytes] : buffers)
        blocks.push_back(packBlock(folder + name, std::span(bytes), BlockKind::Words));
}

BufferState unpackBuffers(const BlockReader& file, const std::string& folder)
{
    BufferState buffers;
    for (const BlockReader::Block& block : file.list())
        if (block.name.starts_with(folder)) buffers[block.name.substr(folder.size())] = file.read(block.name);
    return buffers;
}

/// Numbers N of blocks "<word> N/<part>".
std::vector<uint64_t> numbersOf(const BlockReader& file, std::string_view word, std::string_view part)
{
    std::vector<uint64_t> numbers;
    for (const BlockReader::Block& block : file.list()) {
        const std::string_view name = block.name;
        if (!name.starts_with(word)) continue;
        uint64_t number = 0;
        const char* end = name.data() + name.size();
        const auto [rest, error] = std::from_chars(name.data() + word.size(), end, number);
        if (error == std::errc() && std::string_view(rest, static_cast<size_t>(end - rest)) == part)
            numbers.push_back(number);
    }
    std::ranges::sort(numbers);
    return numbers;
}

}  // namespace

std::vector<std::string> packState(const RunState& state)
{
    Json about = {{"started", state.solver.started}, {"cameras", Json::array()}};
    for (const auto& [name, camera] : state.cameras) {
        Json& own = about["cameras"].emplace_back(Json{{"name", name}});
        if (camera.lookedAt) own["lookedAt"] = *camera.lookedAt;
    }
    std::vector<std::string> blocks{
        packText(stateBlock(state.frame, "about"), about.dump()),
        packArray(stateBlock(state.frame, "parameters"), std::span(&state.solver.stages.parameters, 1))};
    packBuffers(stateBlock(state.frame, SOLVER), state.solver.stages.buffers, blocks);
    size_t index = 0;
    for (const auto& [name, camera] : state.cameras)
        packBuffers(stateBlock(state.frame, rendererPart(index++)), camera.buffers, blocks);
    if (state.between) packBuffers(stateBlock(state.frame, BETWEEN), *state.between, blocks);
    return blocks;
}

bool hasState(const BlockReader& file, uint64_t frame)
{
    return file.has(stateBlock(frame, "about"));
}

RunState unpackState(const BlockReader& file, uint64_t frame)
{
    const std::string name = stateBlock(frame, "about");
    if (!hasState(file, frame)) {
        const std::vector<uint64_t> there = statesOf(file);
        file.refuse(there.empty() ? "has no whole state"
                                  : fmt::format("has no whole state of frame {}; it has those of {}", frame,
                                                fmt::join(there, ", ")));
    }
    const Json about = parseJson(file.readText(name), file.path());
    RunState state;
    state.frame = frame;
    state.solver.started = about.value("started", false);
    const auto parameters = file.readArray<gpu::StepParameters>(stateBlock(frame, "parameters"));
    if (parameters.size() != 1) file.refuse("was written by another version of the program");
    state.solver.stages.parameters = parameters[0];
    state.solver.stages.buffers = unpackBuffers(file, stateBlock(frame, SOLVER));
    BufferState between = unpackBuffers(file, stateBlock(frame, BETWEEN));
    if (!between.empty()) state.between = std::move(between);
    size_t index = 0;
    for (const Json& own : about.value("cameras", Json::array())) {
        RendererState& camera = state.cameras[own.value("name", "")];
        if (own.contains("lookedAt")) camera.lookedAt = own["lookedAt"].get<double>();
        camera.buffers = unpackBuffers(file, stateBlock(frame, rendererPart(index++)));
    }
    return state;
}

std::vector<std::string> packCamera(uint64_t frame, const RendererState& camera)
{
    Json about = Json::object();
    if (camera.lookedAt) about["lookedAt"] = *camera.lookedAt;
    std::vector<std::string> blocks{packText(cameraBlock(frame, "about"), about.dump())};
    packBuffers(cameraBlock(frame, RENDERER), camera.buffers, blocks);
    return blocks;
}

RendererState unpackCamera(const BlockReader& file, uint64_t frame)
{
    const Json about = parseJson(file.readText(cameraBlock(frame, "about")), file.path());
    RendererState camera;
    if (about.contains("lookedAt")) camera.lookedAt = about["lookedAt"].get<double>();
    camera.buffers = unpackBuffers(file, cameraBlock(frame, RENDERER));
    return camera;
}

std::vector<uint64_t> statesOf(const BlockReader& file)
{
    return numbersOf(file, "state ", "/about");
}

std::vector<uint64_t> framesOf(const BlockReader& file)
{
    return numbersOf(file, "frame ", "/positions");
}

}  // namespace knuckle
