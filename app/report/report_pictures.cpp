#include "app/report/report_pictures.h"

#include <algorithm>
#include <cmath>

#include "render/picture/image.h"
#include "render/reader/picture_file.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

uint8_t byteOf(float value)
{
    return std::isnan(value) ? uint8_t{0} : static_cast<uint8_t>(std::clamp(value * STEPS + 0.5f, 0.0f, STEPS));
}

}  // namespace

std::string shownPng(const Picture& picture)
{
    const uint32_t channels = picture.hasAlpha ? 4 : 3;
    std::vector<uint8_t> pixels(picture.pixelCount() * channels);
    for (size_t i = 0; i < picture.pixelCount(); ++i) {
        const float* rgba = &picture.rgba[i * 4];
        const float alpha = std::clamp(rgba[3], 0.0f, 1.0f);
        for (size_t c = 0; c < 3; ++c)
            pixels[i * channels + c] = byteOf(picture.hasAlpha && alpha > 0.0f ? rgba[c] / alpha : rgba[c]);
        if (picture.hasAlpha) pixels[i * channels + 3] = byteOf(alpha);
    }
    return encodePng(picture.width, picture.height, channels, pixels);
}

void readPictures(ReportEntry& entry)
{
    const auto read = [&entry](const std::string& path, std::string& png) {
        if (path.empty()) return;
        try {
            png = shownPng(readPicture(path));
        } catch (const InputError& error) {
            if (entry.status != ReportEntry::Status::Unreadable) entry.notes.emplace_back("problem", error.what());
        }
    };
    read(entry.referencePath, entry.pictures.reference);
    read(entry.outputPath, entry.pictures.output);
}

}  // namespace knuckle
