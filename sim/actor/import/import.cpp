#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string_view>

#include "sim/actor/import/child_process.h"
#include "sim/actor/import/import_scene.h"
#include "sim/actor/import/model.h"
#include "sim/actor/import/model_bytes.h"
#include "sim/actor/import/skeleton_body.h"
#include "sim/world/errors.h"

namespace knuckle {

namespace {

constexpr uint8_t HOLDS_MODEL = 0, HOLDS_MESSAGE = 1;
constexpr uintmax_t FILE_LIMIT = 512ull << 20;        // [bytes]
constexpr float LARGEST_FIGURE = 20.0f;               // taller than this cannot be meant in metres [m]
constexpr float SMALLEST = 0.005f, LARGEST = 200.0f;  // sizes that a guess may lead to [m]
constexpr float PERSON = 1.7f;                        // what a skeleton without a mesh stands for [m]

struct Unit {
    const char* name;
    float metres;
};
constexpr Unit UNITS[] = {{"metres", 1.0f}, {"centimetres", 0.01f}, {"millimetres", 0.001f}};
// Motion capture comes in these; the last is the unit of the CMU library (an inch over 0.45).
constexpr Unit CAPTURE_UNITS[] = {{"metres", 1.0f},
                                  {"centimetres", 0.01f},
                                  {"inches", 0.0254f},
                                  {"millimetres", 0.001f},
                                  {"units of 56.4 mm", 0.0254f / 0.45f}};

float sizeOf(const Model& model)
{
    Eigen::Vector3f low = Eigen::Vector3f::Constant(std::numeric_limits<float>::max()), high = -low;
    const auto include = [&](const Eigen::Vector3f& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    };
    std::for_each(model.vertices.begin(), model.vertices.end(), include);
    for (size_t b = 0; b < model.bones.size() && model.vertices.empty(); ++b) {
        include(model.bones[b].restPose.block<3, 1>(0, 3));
    }
    return (high - low).maxCoeff();
}

void scaleBy(Model& model, float factor)
{
    for (Eigen::Vector3f& vertex : model.vertices) {
        vertex *= factor;
    }
    for (Bone& bone : model.bones) {
        bone.restPose.topRows<3>() *= factor;
    }
    for (Clip& clip : model.clips) {
        for (auto& pose : clip.poses) {
            for (Eigen::Matrix4f& matrix : pose) {
                matrix.topRows<3>() *= factor;
            }
        }
    }
}

// Guesses the file's unit: for a figure too large for metres one that gives a plausible size, for a skeleton without a
// mesh the one that makes it as tall as a person.
const Unit& guessUnit(const Model& model, float size)
{
    if (model.triangles.empty()) {
        return *std::min_element(std::begin(CAPTURE_UNITS), std::end(CAPTURE_UNITS), [&](const Unit& a, const Unit& b) {
            return std::abs(std::log(size * a.metres / PERSON)) < std::abs(std::log(size * b.metres / PERSON));
        });
    }
    for (const Unit& unit : UNITS) {
        if (size * unit.metres <= LARGEST_FIGURE) {
            return unit;
        }
    }
    return UNITS[0];
}

void fitScale(Model& model, const ImportOptions& options)
{
    const float size = sizeOf(model);
    if (!std::isfinite(size) || !(size > 0.0f)) {
        throw InputError("it has no size, or one that is not finite: check the transforms in the file");
    }
    float factor = static_cast<float>(options.scale);
    if (options.scale == 0.0) {
        const Unit& unit = guessUnit(model, size);
        factor = unit.metres;
        if (factor != 1.0f) {
            model.notes.push_back(fmt::format("The model measures {:.4g} units: taken for {}, so {:.3g} m.", size,
                                              unit.name, size * factor));
        }
    }
    const float metres = size * factor;
    if (!(metres >= SMALLEST && metres <= LARGEST)) {
        throw InputError(fmt::format("it would be {:.3g} m large, {:g} to {:g} m are possible: give a scale in metres "
                                     "per unit (the file has {:.4g} units)",
                                     metres, SMALLEST, LARGEST, size));
    }
    if (factor != 1.0f) {
        scaleBy(model, factor);
    }
}

Model readWhole(const std::string& path, const ImportOptions& options)
{
    Model model = readScene(path, options.surface);
    const bool bare = model.triangles.empty() && model.vertices.empty();
    if (bare && model.bones.size() >= 2) {
        unfoldRestPose(model);
    }
    if (model.triangles.empty() && !(bare && model.bones.size() >= 2)) {
        throw InputError("it holds neither triangles nor a skeleton: export a mesh");
    }
    fitScale(model, options);
    if (bare) {
        addBodyAlongBones(model);
    }
    if (!options.clips) {
        model.clips.clear();
        model.unusableClips.clear();
    }
    return model;
}

std::vector<uint8_t> inChild(const std::string& path, const ImportOptions& options)
{
    std::vector<uint8_t> bytes;
    try {
        bytes = toBytes(readWhole(path, options));
        bytes.insert(bytes.begin(), HOLDS_MODEL);
    } catch (const InputError& error) {
        const std::string message = error.what();
        bytes.assign(1, HOLDS_MESSAGE);
        bytes.insert(bytes.end(), message.begin(), message.end());
    }
    return bytes;
}

void checkFile(const std::string& path)
{
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (error || !std::filesystem::exists(status)) {
        throw InputError(fmt::format("{}: there is no such file", path));
    }
    if (!std::filesystem::is_regular_file(status)) {
        throw InputError(fmt::format("{}: is not a file", path));
    }
    if (!std::ifstream(path).good()) {
        throw InputError(fmt::format("{}: cannot be opened: check its permissions", path));
    }
    const uintmax_t size = std::filesystem::file_size(path, error);
    if (error || size == 0) {
        throw InputError(fmt::format("{}: is empty: export the model again", path));
    }
    // Binary glTF says how long it is; assimp reads what is left of a shorter one.
    std::array<char, 12> header{};
    std::ifstream(path, std::ios::binary).read(header.data(), header.size());
    uint32_t promised = 0;
    std::memcpy(&promised, header.data() + 8, sizeof promised);
    if (std::string_view(header.data(), 4) == "glTF" && promised > size) {
        throw InputError(
            fmt::format("{}: is cut off: {} of {} bytes are there; export the model again", path, size, promised));
    }
    if (size > FILE_LIMIT) {
        throw InputError(fmt::format("{}: is larger than {} MiB: simplify the model", path, FILE_LIMIT >> 20));
    }
}

// Names in broken files may hold anything; the message stays one line that a terminal can show.
std::string oneLine(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    text.resize(std::min<size_t>(text.size(), 500));
    return text;
}

}  // namespace

Model importModel(const std::string& path, const ImportOptions& options)
{
    if (!(options.scale >= 0.0) || !std::isfinite(options.scale)) {
        throw InputError(fmt::format("{}: scale {} must be above 0 metres per unit", path, options.scale));
    }
    checkFile(path);
    const ChildResult result = runInChild([&] { return inChild(path, options); }, {});
    if (!result.ok) {
        throw InputError(fmt::format("{}: the importer {}: the file is damaged or too large; export it again", path,
                                     result.failure));
    }
    if (result.bytes.empty() || result.bytes[0] != HOLDS_MODEL) {
        throw InputError(oneLine(fmt::format(
            "{}: {}", path, std::string(result.bytes.begin() + !result.bytes.empty(), result.bytes.end()))));
    }
    Model model;
    if (!fromBytes(std::span(result.bytes).subspan(1), model)) {
        throw InputError(fmt::format("{}: the importer made nothing usable of it: the file is damaged; export it "
                                     "again",
                                     path));
    }
    return model;
}

}  // namespace knuckle
