#include "render/compare/comparison.h"

#include <algorithm>
#include <optional>

#include "render/compare/antialiasing.h"
#include "render/compare/parallel.h"
#include "sim/base/cores.h"

namespace knuckle {

namespace {

unsigned threadsOf(const CompareSettings& settings)
{
    return settings.threads > 0 ? settings.threads : usableCores();
}

PictureComparison sizesOf(const Picture& first, const Picture& second, const CompareSettings& settings)
{
    PictureComparison result;
    result.width = first.width;
    result.height = first.height;
    result.secondWidth = second.width;
    result.secondHeight = second.height;
    result.threshold = settings.threshold;
    result.hdr = first.hdr && second.hdr;
    return result;
}

/// A copy of the second picture in which all that does not count is as in the first one: no metric can see it.
struct Masked {
    std::optional<Picture> second;
    uint64_t antialiased = 0;
};

void copyPixel(const Picture& from, Picture& to, size_t pixel)
{
    std::copy_n(from.rgba.begin() + static_cast<ptrdiff_t>(pixel * 4), 4,
                to.rgba.begin() + static_cast<ptrdiff_t>(pixel * 4));
}

Masked maskSecond(const Picture& first, const Picture& second, const std::vector<uint8_t>& ignored,
                  const CompareSettings& settings, unsigned threads)
{
    Masked masked;
    if (ignored.empty() && !settings.ignoreAntialiasing) return masked;
    masked.second = second;
    for (size_t i = 0; i < ignored.size(); ++i)
        if (ignored[i] != 0) copyPixel(first, *masked.second, i);
    if (!settings.ignoreAntialiasing) return masked;
    // Edges are looked for in the pictures as they are: what is masked has neighbours, too.
    std::vector<uint64_t> found(first.height);
    forEachParallel(first.height, threads, [&](size_t y) {
        for (uint32_t x = 0; x < first.width; ++x) {
            const size_t i = y * first.width + x;
            if (pixelDifference(&first.rgba[i * 4], &masked.second->rgba[i * 4]) <= 0.0f) continue;
            if (!isAntialiasedEdge(first, second, x, static_cast<uint32_t>(y))) continue;
            copyPixel(first, *masked.second, i);
            ++found[y];
        }
    });
    for (const uint64_t count : found) masked.antialiased += count;
    return masked;
}

}  // namespace

PictureComparison comparePictures(const Picture& first, const Picture& second, const CompareSettings& settings)
{
    PictureComparison result = sizesOf(first, second, settings);
    if (!result.sameSize()) return result;
    const unsigned threads = threadsOf(settings);
    const std::vector<uint8_t> ignored = findIgnored(first, second, settings.ignored);
    result.compared = first.pixelCount() - static_cast<uint64_t>(std::ranges::count(ignored, 1));
    const Masked masked = maskSecond(first, second, ignored, settings, threads);
    const Picture& seen = masked.second ? *masked.second : second;
    result.antialiased = masked.antialiased;
    result.differences = findDifferences(first, seen, settings.threshold, result.compared, threads);
    if (result.differences.differing == 0) return result;
    const std::vector<uint8_t>& marks = result.differences.marks;
    result.tile = findWorstTile(first, seen, marks, threads);
    const uint8_t least = result.differences.changed > 0 ? 2 : 1;
    result.places = findPlaces(marks, result.width, result.height, least);
    if (settings.withFlip) result.flip = flip(first, seen, marks, settings.flip, result.compared, threads);
    if (settings.withSsim) result.ssim = ssim(first, seen, marks, settings.flip.background, threads);
    return result;
}

PictureComparison identicalPictures(const Picture& picture, const CompareSettings& settings)
{
    PictureComparison result = sizesOf(picture, picture, settings);
    const std::vector<uint8_t> ignored = findIgnored(picture, picture, settings.ignored);
    result.compared = picture.pixelCount() - static_cast<uint64_t>(std::ranges::count(ignored, 1));
    result.differences.marks.resize(picture.pixelCount());
    return result;
}

Picture pictureOf(uint32_t width, uint32_t height, const std::vector<uint8_t>& rgb)
{
    Picture picture;
    picture.width = width;
    picture.height = height;
    picture.rgba.reserve(picture.pixelCount() * 4);
    for (size_t i = 0; i + 2 < rgb.size(); i += 3) {
        for (size_t c = 0; c < 3; ++c) picture.rgba.push_back(static_cast<float>(rgb[i + c]) / STEPS);
        picture.rgba.push_back(1.0f);
    }
    return picture;
}

Picture pictureOf(const Image& image)
{
    return pictureOf(image.width, image.height, image.rgb);
}

}  // namespace knuckle
