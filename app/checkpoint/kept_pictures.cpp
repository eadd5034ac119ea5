#include "app/checkpoint/kept_pictures.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/states/file_checksum.h"

namespace knuckle {

namespace {

std::string prefixOf(size_t output)
{
    return fmt::format("picture {}/", output);
}

}  // namespace

std::string KeptPictures::block(uint64_t frame, const std::string& sum) const
{
    return packText(prefixOf(number_) + std::to_string(frame), sum);
}

bool KeptPictures::has(uint64_t number)
{
    const std::lock_guard lock(mutex_);
    return whole_.contains(number);
}

void KeptPictures::written(uint64_t number, std::string_view bytes)
{
    const std::lock_guard lock(mutex_);
    whole_[number] = checksumOf(bytes);
    news_.insert(number);
}

void KeptPictures::check(const BlockReader& log)
{
    const std::string prefix = prefixOf(number_);
    for (const BlockReader::Block& block : log.list()) {
        if (!block.name.starts_with(prefix)) continue;
        const uint64_t frame = std::stoull(block.name.substr(prefix.size()));
        const std::string file = names_.path(frame), sum = log.readText(block.name);
        if (std::filesystem::exists(file) && fileChecksum(file) == sum) whole_[frame] = sum;
    }
}

void KeptPictures::forget()
{
    whole_.clear();
    news_.clear();
}

std::vector<std::string> KeptPictures::news()
{
    const std::lock_guard lock(mutex_);
    std::vector<std::string> blocks;
    for (const uint64_t frame : news_) blocks.push_back(block(frame, whole_.at(frame)));
    news_.clear();
    return blocks;
}

std::vector<std::string> KeptPictures::all()
{
    const std::lock_guard lock(mutex_);
    std::vector<std::string> blocks;
    for (const auto& [frame, sum] : whole_) blocks.push_back(block(frame, sum));
    return blocks;
}

}  // namespace knuckle
