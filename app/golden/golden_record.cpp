#include "app/golden/golden_record.h"

#include <fmt/format.h>

#include <memory>

#include "app/golden/golden_images.h"
#include "app/golden/golden_scene.h"
#include "app/states/file_checksum.h"
#include "app/states/picture_labels.h"
#include "render/reader/picture_file.h"
#include "sim/base/errors.h"
#include "sim/base/files/output_file.h"
#include "sim/base/fnv_hash.h"

namespace knuckle {

namespace {

/// Simulates, and notes the states and where they come from.
std::vector<StoredFrame> simulateStates(const Golden& golden, GoldenScene& scene, GoldenRecord& record)
{
    std::vector<StoredFrame> frames;
    scene.simulate(golden.frames, true, [&](const GoldenScene::Simulated& at) {
        record.states[at.frame] = hashText(at.state.stateHash());
        frames.push_back({at.frame, at.state.readView(), at.camera->saveState()});
        compact(frames.back().view, scene.scene());
    });
    return frames;
}

/// The frames of a golden whose pictures are made, from its file of states.
std::vector<StoredFrame> readStates(const Golden& golden, const RecordWork& work)
{
    const StoredFrames stored(golden.statesFile(work.key));
    std::vector<StoredFrame> frames;
    for (const uint64_t frame : work.frames) {
        if (!golden.recorded.at(work.key).states.contains(frame))
            throw InputError(fmt::format("{}: has no state of frame {}; leave out --pictures", golden.path(), frame));
        frames.push_back(stored.read(frame));
    }
    return frames;
}

/// All files are written under other names before any gets its own.
std::vector<std::string> recordScene(Golden& golden, const RecordWork& work, Gpu& gpu, const InterruptGuard& interrupt)
{
    GoldenScene scene(golden, {}, gpu, interrupt);
    const RunFacts facts = scene.facts(golden);
    GoldenRecord record{facts.fingerprint.driver, facts.fingerprint.device, facts.fingerprint.program};
    if (!work.states) record = golden.recorded.at(work.key);
    const std::vector<StoredFrame> frames = work.states ? simulateStates(golden, scene, record)
                                                        : readStates(golden, work);
    std::vector<std::string> written;
    std::vector<std::unique_ptr<OutputFile>> pictures;
    for (const StoredFrame& frame : frames) {
        if (!work.frames.contains(frame.number)) continue;
        Image image = scene.draw(frame);
        image.text = labelsOf(facts, frame.number, std::stoull(record.states.at(frame.number), nullptr, 16));
        written.push_back(golden.reference(golden.frameStem(frame.number), work.key));
        pictures.push_back(std::make_unique<OutputFile>(written.back()));
        pictures.back()->write(pngOf(image, PngEffort::Small));
    }
    const std::string states = golden.statesFile(work.key);
    if (work.states) {
        writeStoredFrames(states, scene.scene(), facts, frames);
        written.push_back(states);
    }
    for (const auto& picture : pictures) picture->commit();
    record.file = fileChecksum(states);
    golden.recorded[work.key] = std::move(record);
    return written;
}

std::vector<std::string> recordImages(Golden& golden, const RecordWork& work)
{
    requireOwnReferences(golden, work.key);
    if (!work.made) makeImages(golden);
    std::vector<std::string> written;
    for (const std::string& image : golden.images) {
        if (!work.images.contains(Golden::imageStem(image))) continue;
        const std::string output = golden.imagePath(image), bytes = readPictureBytes(output);
        decodePicture(bytes, output);  // what cannot be read is no reference
        written.push_back(golden.imageReference(image, work.key));
        writeFile(written.back(), bytes);
    }
    golden.recorded[work.key];
    return written;
}

}  // namespace

RecordWork wholeWork(const Golden& golden, const std::string& key)
{
    RecordWork work{.key = key, .frames = {golden.frames.begin(), golden.frames.end()}};
    for (const std::string& image : golden.images) work.images.insert(Golden::imageStem(image));
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
