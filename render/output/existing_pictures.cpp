#include "render/output/existing_pictures.h"

#include <fstream>
#include <iterator>
#include <utility>

#include "render/picture/whole_picture.h"

namespace knuckle {

ExistingPictures::ExistingPictures(FrameNames names, uint32_t width, uint32_t height, PictureKeep* keep)
    : names_(std::move(names)), width_(width), height_(height), keep_(keep)
{
}

bool ExistingPictures::has(uint64_t number)
{
    const std::lock_guard lock(mutex_);
    if (whole_.contains(number) || (keep_ != nullptr && keep_->has(number))) return true;
    std::ifstream file(names_.path(number), std::ios::binary);
    if (!file) return false;
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (!isWholePicture(bytes, width_, height_)) return false;
    whole_.insert(number);
    if (keep_ != nullptr) keep_->written(number, bytes);
    return true;
}

void ExistingPictures::written(uint64_t number, std::string_view bytes)
{
    const std::lock_guard lock(mutex_);
    whole_.insert(number);
    if (keep_ != nullptr) keep_->written(number, bytes);
}

}  // namespace knuckle
