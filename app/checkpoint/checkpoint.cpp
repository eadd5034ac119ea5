#include "app/checkpoint/checkpoint.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "render/output/film_segments.h"
#include "sim/base/errors.h"

namespace knuckle {

Checkpoint::Checkpoint(const CheckpointOptions& options, const std::vector<std::string>& outputs,
                       const FrameRange& range, const World& world)
    : options_(options), folder_(checkpointPath(outputs.at(0)), options.folders), range_(range), coding_(world)
{
    facts_.words = options.words;
}

PictureKeep* Checkpoint::pictures(size_t output, const FrameNames& names)
{
    return (pictures_[output] = std::make_unique<KeptPictures>(output, names)).get();
}

FilmKeep* Checkpoint::film(size_t output)
{
    return (films_[output] = std::make_unique<KeptFilm>(folder_.film(output))).get();
}

std::optional<RunState> Checkpoint::begin(const RunFingerprint& fingerprint, uint64_t last)
{
    facts_.fingerprint = fingerprint;
    std::vector<FoundCheckpoint> found;
    if (options_.resume) found = folder_.find(notes_);
    if (found.empty()) {
        beginAnew(false);
        if (!notes_.empty()) notes_.emplace_back("no checkpoint is whole: begins anew");
        return {};
    }
    requireSameRun(found[0], last);
    for (const auto& [output, film] : films_) film->check();
    for (const auto& [output, pictures] : pictures_) pictures->check(*found[0].log);
    std::optional<uint64_t> missing;
    for (FoundCheckpoint& checkpoint : found) {
        missing = firstMissing(checkpoint.facts.frame);
        if (missing) continue;
        facts_.frame = checkpoint.facts.frame;
        RunState state = unpackState(*checkpoint.state, facts_.frame);
        log_.emplace(folder_.log(), checkpoint.facts.logBytes);
        earlier_ = std::move(checkpoint.log);
        notes_.push_back(fmt::format("goes on after frame {}, from {}", facts_.frame, folder_.path()));
        return state;
    }
    notes_.push_back(
        fmt::format("frame {} is missing or damaged: simulates from the start, and draws what is missing", *missing));
    beginAnew(true);
    return {};
}

void Checkpoint::requireSameRun(const FoundCheckpoint& found, uint64_t last) const
{
    const CheckpointFacts& facts = found.facts;
    if (facts.words != options_.words)
        throw InputError(
            fmt::format("{}: was left by a run with other outputs, {}; give the same, or begin anew without "
                        "--resume",
                        folder_.path(), fmt::join(facts.words, " ")));
    const std::vector<std::string> different = differences(facts_.fingerprint, facts.fingerprint);
    if (!different.empty() && !options_.loose)
        throw InputError(fmt::format("{}: was left by another run: {}; --resume=loose goes on all the same, with other "
                                     "bits, and without --resume it begins anew",
                                     folder_.path(), fmt::join(different, ", ")));
    if (facts.frame > last)
        throw InputError(
            fmt::format("{}: has come to frame {}, and the last is {}; raise /duration or begin anew without "
                        "--resume",
                        folder_.path(), facts.frame, last));
}

bool Checkpoint::isWhole(uint64_t frame)
{
    const uint64_t index = range_.indexOf(frame);
    return std::ranges::all_of(pictures_, [&](const auto& entry) { return entry.second->has(frame); }) &&
           std::ranges::all_of(films_, [&](const auto& entry) {
               return !entry.second->segment(index / SEGMENT_FRAMES).empty() || entry.second->hasFrame(index);
           });
}

std::optional<uint64_t> Checkpoint::firstMissing(uint64_t last)
{
    for (uint64_t frame = range_.first; frame <= last; frame += range_.stride)
        if (!isWhole(frame)) return frame;
    return {};
}

void Checkpoint::beginAnew(bool keepFrames)
{
    folder_.clear();
    log_.emplace(folder_.log(), 0);
    if (!keepFrames)
        for (const auto& [output, film] : films_) film->forget();
    for (const auto& [output, pictures] : pictures_) {
        if (keepFrames) log_->add(pictures->all());
        else pictures->forget();
    }
}

void Checkpoint::replay(uint64_t first, const std::function<void(const FrameRecord&)>& give) const
{
    for (uint64_t frame = first; earlier_ && frame <= facts_.frame; ++frame)
        give(unpackRecord(*earlier_, frame, coding_));
}

void Checkpoint::log(const FrameRecord& record)
{
    log_->add(packRecord(record, coding_));
}

bool Checkpoint::isDue() const
{
    return options_.seconds && std::chrono::duration<double>(Clock::now() - saved_).count() >= *options_.seconds;
}

void Checkpoint::save(const RunState& state)
{
    for (const auto& [output, pictures] : pictures_) log_->add(pictures->news());
    facts_.frame = state.frame;
    facts_.logBytes = log_->sync();
    folder_.write(facts_, state);
    saved_ = Clock::now();
}

}  // namespace knuckle
