#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "sim/base/errors.h"
#include "sim/base/lowercase.h"
#include "sim/rig/import/assimp/read_scene.h"
#include "sim/rig/import/child_process.h"
#include "sim/rig/import/file_check.h"
#include "sim/rig/import/fit.h"
#include "sim/rig/import/import.h"
#include "sim/rig/import/model_bytes.h"
#include "sim/rig/import/skeleton/rest_pose.h"
#include "sim/rig/import/skeleton/skeleton_body.h"
#include "sim/rig/import/skeleton/upright.h"
#include "sim/rig/import/valid_text.h"

namespace knuckle {

namespace {

constexpr uint8_t HOLDS_MODEL = 0, HOLDS_MESSAGE = 1, HOLDS_SKELETONS = 2;
constexpr uintmax_t FILE_LIMIT = 512ull << 20;  // [bytes]

/// Names in old formats have any encoding; everything written of them is UTF-8.
void makeTextsValid(Model& model)
{
    const auto fix = [](std::string& text) { text = validText(text); };
    fix(model.name);
    fix(model.poseFrom);
    for (Bone& bone : model.bones) fix(bone.name);
    for (Clip& clip : model.clips) {
        fix(clip.name);
        for (std::string& note : clip.notes) fix(note);
    }
    for (SkinMaterial& material : model.surface.materials) fix(material.name);
    for (UnusableClip& clip : model.unusableClips) {
        fix(clip.name);
        fix(clip.why);
    }
    for (auto* notes : {&model.notes, &model.surface.notes, &model.surface.missing})
        for (std::string& note : *notes) fix(note);
}

/// Whether bones are at more than one place: nodes of a scene without meshes may be cameras and groups.
bool hasSkeleton(const Model& model)
{
    for (uint32_t b = 1; b < model.bones.size(); ++b) {
        if (boneHead(model, b) != boneHead(model, 0)) return true;
        for (const Clip& clip : model.clips)
            if (!clip.poses[0][b].col(3).isApprox(clip.poses[0][0].col(3))) return true;
    }
    return false;
}

Model readWhole(const std::string& path, const ImportOptions& options)
{
    Model model = readScene(path, options.surface, options.pick);
    const bool bare = model.triangles.empty() && model.vertices.empty() && hasSkeleton(model);
    if (model.triangles.empty() && !bare) throw InputError(NO_MESH);
    std::vector<BoneAnatomy> anatomy;
    if (bare) {
        anatomy = readAnatomy(model);
        const bool saysNoAxis = lowercase(std::filesystem::path(path).extension().string()) == ".bvh";
        if (saysNoAxis && options.fit.up == UpAxis::Y && standUpright(model, anatomy)) anatomy = readAnatomy(model);
        if (chooseRestPose(model, anatomy)) anatomy = readAnatomy(model);
    }
    fitModel(model, options.fit);
    if (bare) addBodyAlongBones(model, anatomy);
    if (!options.clips) {
        model.clips.clear();
        model.unusableClips.clear();
    }
    makeTextsValid(model);
    return model;
}

std::vector<uint8_t> inChild(const std::string& path, const ImportOptions& options)
{
    const auto said = [](uint8_t kind, const std::string& words) {
        const std::string message = validText(words);
        std::vector<uint8_t> bytes(1, kind);
        bytes.insert(bytes.end(), message.begin(), message.end());
        return bytes;
    };
    try {
        std::vector<uint8_t> bytes = toBytes(readWhole(path, options));
        bytes.insert(bytes.begin(), HOLDS_MODEL);
        return bytes;
    } catch (const SkeletonError& error) {
        return said(HOLDS_SKELETONS, error.what());
    } catch (const InputError& error) {
        return said(HOLDS_MESSAGE, error.what());
    }
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
    // Binary glTF states its length; of a shorter file assimp reads what is left.
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

// Names in broken files may contain anything; the message stays one line that a terminal can show.
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
    if (!(options.fit.scale >= 0.0) || !std::isfinite(options.fit.scale)) {
        throw InputError(fmt::format("{}: scale {} must be above 0 metres per unit", path, options.fit.scale));
    }
    if (!(options.fit.height >= 0.0) || !std::isfinite(options.fit.height)) {
        throw InputError(fmt::format("{}: height {} must be above 0 metres", path, options.fit.height));
    }
    checkFile(path);
    const ChildResult result = runInChild([&] { return inChild(path, options); }, {});
    if (!result.ok) {
        throw InputError(fmt::format("{}: the importer {}: the file is damaged or too large; export it again", path,
                                     result.failure));
    }
    if (result.bytes.empty() || result.bytes[0] != HOLDS_MODEL) {
        const std::string message = oneLine(
            fmt::format("{}: {}", path, std::string(result.bytes.begin() + !result.bytes.empty(), result.bytes.end())));
        if (!result.bytes.empty() && result.bytes[0] == HOLDS_SKELETONS) throw SkeletonError(message);
        throw InputError(message);
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
