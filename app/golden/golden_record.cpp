#include "app/golden/golden_record.h"

#include <filesystem>

#include "app/golden/golden_images.h"
#include "app/golden/golden_scene.h"
#include "app/states/picture_labels.h"
#include "render/reader/picture_file.h"
#include "sim/base/files/output_file.h"
#include "sim/base/fnv_hash.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

/// Simulates, writes the file of states, and notes where they come from.
void recordStates(Golden& golden, const std::string& key, GoldenScene& scene, const RunFacts& facts)
{
    std::vector<StoredFrame> frames;
    GoldenRecord record{facts.fingerprint.driver, facts.fingerprint.device, facts.fingerprint.program, {}};
    scene.simulate(golden.frames, true, [&](const GoldenScene::Simulated& at) {
        record.states[at.frame] = hashText(at.solver.stateHash());
        frames.push_back({at.frame, at.solver.readView(), at.camera->saveState()});
        compact(frames.back().view, scene.scene());
    });
    writeStoredFrames(golden.statesFile(key), scene.scene(), facts, frames);
    golden.recorded[key] = std::move(record);
}

std::vector<std::string> recordScene(Golden& golden, const RecordWork& work, Gpu& gpu, const InterruptGuard& interrupt)
{
    GoldenScene scene(golden, {}, gpu, interrupt);
    const RunFacts facts = scene.facts(golden);
    std::vector<std::string> written;
    if (work.states) {
        recordStates(golden, work.key, scene, facts);
        written.push_back(golden.statesFile(work.key));
    }
    const StoredFrames stored(golden.statesFile(work.key));
    for (const uint64_t frame : work.frames) {
        Image image = scene.draw(stored.read(frame));
        const std::string hash = golden.recorded.at(work.key).states.at(frame);
        image.text = labelsOf(facts, frame, std::stoull(hash, nullptr, 16));
        written.push_back(golden.reference(golden.frameStem(frame), work.key));
        writeFile(written.back(), pngOf(image, PngEffort::Small));
    }
    return written;
}

std::vector<std::string> recordImages(Golden& golden, const RecordWork& work)
{
    makeImages(golden);
    std::vector<std::string> written;
    for (const std::string& image : golden.images) {
        const fs::path output = fs::path(golden.commandFolder) / image;
        if (!work.images.contains(output.stem().string())) continue;
        const std::string bytes = readPictureBytes(output.string());
        decodePicture(bytes, output.string());  // what cannot be read is no reference
        written.push_back(golden.reference(output.stem().string(), work.key, output.extension().string()));
        writeFile(written.back(), bytes);
    }
    golden.recorded[work.key];
    return written;
}

}  // namespace

RecordWork wholeWork(const Golden& golden, const std::string& key)
{
    RecordWork work{.key = key, .frames = {golden.frames.begin(), golden.frames.end()}};
    for (const std::string& image : golden.images) work.images.insert(fs::path(image).stem().string());
    return work;
}

std::vector<std::string> recordGolden(Golden& golden, const RecordWork& work, Gpu* gpu, const InterruptGuard& interrupt)
{
    std::vector<std::string> written = golden.ofScene() ? recordScene(golden, work, *gpu, interrupt)
                                                        : recordImages(golden, work);
    writeGolden(golden);
    written.push_back(golden.path());
    return written;
}

}  // namespace knuckle
