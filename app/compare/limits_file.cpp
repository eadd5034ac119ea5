#include "app/compare/limits_file.h"

#include "app/schema/schema.h"
#include "sim/rig/anatomy/names/name_pattern.h"

namespace knuckle {

namespace {

GivenLimits givenBy(const Json& json)
{
    GivenLimits limits;
    const auto take = [&json](const char* key, auto& value) {
        if (const auto found = json.find(key); found != json.end())
            value = found->get<typename std::remove_reference_t<decltype(value)>::value_type>();
    };
    take("threshold", limits.threshold);
    take("pixels", limits.pixels);
    take("share", limits.share);
    take("mean", limits.mean);
    take("largest", limits.largest);
    take("tile", limits.tile);
    take("flip", limits.flip);
    take("ssim", limits.ssim);
    return limits;
}

}  // namespace

void GivenLimits::applyTo(float& newThreshold, CompareLimits& limits) const
{
    if (threshold) newThreshold = static_cast<float>(*threshold);
    if (pixels) {
        limits.pixels = pixels;
        limits.share.reset();
    }
    if (share) limits.share = share;
    if (mean) limits.mean = mean;
    if (largest) limits.largest = largest;
    if (tile) limits.tile = tile;
    if (flip) limits.flip = flip;
    if (ssim) limits.ssim = ssim;
}

void LimitsFile::applyTo(const std::string& name, float& threshold, CompareLimits& limits) const
{
    general.applyTo(threshold, limits);
    const GivenLimits* found = findByPattern(names, name);
    if (found == nullptr) found = findByPattern(names, name.substr(name.rfind('/') + 1));
    if (found != nullptr) found->applyTo(threshold, limits);
}

LimitsFile limitsOf(const Json& json)
{
    LimitsFile limits;
    if (const auto general = json.find("default"); general != json.end()) limits.general = givenBy(*general);
    if (const auto names = json.find("names"); names != json.end())
        for (const auto& [pattern, given] : names->items()) limits.names[pattern] = givenBy(given);
    return limits;
}

LimitsFile readLimits(const std::string& path)
{
    static const Schema schema("limits.schema.json");
    JsonFile file = readJsonFile(path);
    schema.complete(file);
    return limitsOf(file.root);
}

}  // namespace knuckle
