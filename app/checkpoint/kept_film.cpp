#include "app/checkpoint/kept_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>

#include "app/states/block_file.h"
#include "app/states/file_checksum.h"
#include "render/output/film_segments.h"
#include "sim/base/errors.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

constexpr const char *PICTURE = "picture", *CHANGES = "changes", *FRAME = "frame_", *SEGMENT = "segment_";

/// A name that tells whether the file is whole.
std::string segmentName(uint64_t segment, const std::string& path)
{
    return fmt::format("{}{:04}.{}.mp4", SEGMENT, segment + 1, fileChecksum(path));
}

/// The number after the word with which a name begins.
std::optional<uint64_t> numberAfter(const std::string& name, const std::string& word)
{
    unsigned long long number = 0;
    if (!name.starts_with(word) || std::sscanf(name.c_str() + word.size(), "%llu", &number) != 1) return {};
    return number;
}

/// The first frame of the segment of a frame.
uint64_t firstOf(uint64_t index)
{
    return index - index % SEGMENT_FRAMES;
}

/// The bits in which two pictures differ; and with them the one from the other. @param b of the same size.
std::vector<uint8_t> differing(std::vector<uint8_t> a, const std::vector<uint8_t>& b)
{
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) a[i] ^= b[i];
    return a;
}

}  // namespace

KeptFilm::KeptFilm(std::string folder) : folder_(std::move(folder))
{
    requireWritableFolder(folder_);
}

std::string KeptFilm::framePath(uint64_t index) const
{
    return fmt::format("{}/{}{:06}", folder_, FRAME, index + 1);
}

std::string KeptFilm::segment(uint64_t segment)
{
    const std::lock_guard lock(mutex_);
    const auto found = segments_.find(segment);
    return found == segments_.end() ? "" : found->second;
}

bool KeptFilm::hasFrame(uint64_t index)
{
    const std::lock_guard lock(mutex_);
    return frames_.contains(index);
}

std::vector<uint8_t> KeptFilm::readFrame(uint64_t index)
{
    const BlockReader file(framePath(index));
    if (!file.has(CHANGES)) return file.readArray<uint8_t>(PICTURE);
    return differing(file.readArray<uint8_t>(CHANGES), readFrame(firstOf(index)));
}

void KeptFilm::keepFrame(uint64_t index, const std::vector<uint8_t>& rgb)
{
    const uint64_t first = firstOf(index);
    const bool changes = index != first && firstIndex_ == first && first_.size() == rgb.size();
    BlockWriter writer(framePath(index));
    const std::vector<uint8_t> kept = changes ? differing(rgb, first_) : std::vector<uint8_t>();
    writer.add(
        packBlock(changes ? CHANGES : PICTURE, std::as_bytes(std::span(changes ? kept : rgb)), BlockKind::Quick));
    writer.commit();
    if (index == first) {
        first_ = rgb;
        firstIndex_ = first;
    }
    const std::lock_guard lock(mutex_);
    frames_.insert(index);
}

void KeptFilm::endSegment(uint64_t segment, const std::string& name)
{
    const std::string from = folder_ + "/" + name, to = segmentName(segment, from);
    fs::rename(from, folder_ + "/" + to);
    const std::lock_guard lock(mutex_);
    segments_[segment] = to;
    for (uint64_t index = segment * SEGMENT_FRAMES; index < (segment + 1) * SEGMENT_FRAMES; ++index) {
        std::remove(framePath(index).c_str());
        frames_.erase(index);
    }
}

void KeptFilm::check()
{
    std::set<uint64_t> changed;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
        const std::string name = entry.path().filename(), path = entry.path();
        if (const auto segment = numberAfter(name, SEGMENT)) {
            if (name == segmentName(*segment - 1, path)) segments_[*segment - 1] = name;
            else std::remove(path.c_str());
        } else if (const auto frame = numberAfter(name, FRAME)) {
            try {
                if (BlockReader(path).has(CHANGES)) changed.insert(*frame - 1);
                frames_.insert(*frame - 1);
            } catch (const InputError&) {
                std::remove(path.c_str());
            }
        }
    }
    for (const uint64_t index : changed)
        if (!frames_.contains(firstOf(index))) frames_.erase(index);
}

void KeptFilm::forget()
{
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) std::remove(entry.path().c_str());
    segments_.clear();
    frames_.clear();
}

}  // namespace knuckle
