#include "render/compare/flip/flip.h"

#include <algorithm>
#include <cmath>

#include "render/compare/flip/flip_tile.h"
#include "render/compare/parallel.h"
#include "sim/base/colors.h"

namespace knuckle {

namespace {

/// Side of the parts that are worked on at a time: small enough for a processor's cache.
constexpr uint32_t TILE = 128;
constexpr uint32_t MOST_EXPOSURES = 64;
/// The largest that a half float holds; what is larger, or no number, counts as this, or as black.
constexpr float MOST_LIGHT = 65504.0f;

/// The ACES tone mapper's curve, (A x x + B x) / (C x x + D x + E), with its exposure of 0.6 taken out.
constexpr float ACES_A = 0.6f * 0.6f * 2.51f, ACES_B = 0.6f * 0.03f, ACES_C = 0.6f * 0.6f * 2.43f,
                ACES_D = 0.6f * 0.59f, ACES_E = 0.14f;
/// The tone that the brightest pixel gets at the first exposure, and the median at the last one.
constexpr double EXPOSED_TONE = 0.85;

float lightOf(float encoded)
{
    if (std::isnan(encoded)) return 0.0f;
    return std::clamp(decodeSrgb(encoded), 0.0f, MOST_LIGHT);
}

/// Linear values of the 256 steps of 8-bit pictures: most pixels are one of them.
struct StepTable {
    std::array<float, 256> light;
    StepTable()
    {
        for (size_t i = 0; i < light.size(); ++i) light[i] = linearOfSrgb(static_cast<float>(i) / 255.0f);
    }
    float of(float encoded) const
    {
        if (!(encoded > 0.0f)) return 0.0f;
        if (encoded >= 1.0f) return 1.0f;
        const float step = encoded * 255.0f, above = step + 0.5f;
        const int nearest = static_cast<int>(above);
        return std::fabs(step - static_cast<float>(nearest)) < 1e-4f ? light[static_cast<size_t>(nearest)]
                                                                     : linearOfSrgb(encoded);
    }
};

class FlipRun {
public:
    FlipRun(const Picture& a, const Picture& b, const std::vector<uint8_t>& marks, const FlipSettings& settings)
        : a_(a), b_(b), marks_(marks), settings_(settings), filters_(makeFlipFilters(settings.pixelsPerDegree)),
          hdr_(a.hdr && b.hdr), columns_((a.width + TILE - 1) / TILE), rows_((a.height + TILE - 1) / TILE)
    {
        if (hdr_) exposures_ = exposuresOf(a);
    }

    FlipResult run(uint64_t compared, unsigned threads)
    {
        FlipResult result;
        result.errors.resize(a_.pixelCount());
        forEachParallel(rows_ * columns_, threads, [&](size_t i) {
            const auto column = static_cast<uint32_t>(i % columns_), row = static_cast<uint32_t>(i / columns_);
            PixelPart part{column * TILE, row * TILE, 0, 0};
            part.width = std::min(TILE, a_.width - part.x);
            part.height = std::min(TILE, a_.height - part.y);
            if (isMarked(part)) fill(part, result.errors);
        });
        double sum = 0.0;
        for (const float error : result.errors) {
            sum += static_cast<double>(error);
            result.max = std::max(result.max, static_cast<double>(error));
        }
        result.mean = sum / static_cast<double>(std::max<uint64_t>(1, compared));
        if (result.max <= 0.0) result.errors.clear();
        return result;
    }

private:
    struct PixelPart {
        uint32_t x, y, width, height;
    };

    bool isMarked(const PixelPart& part) const
    {
        const uint32_t reach = filters_.reach;
        const uint32_t left = part.x - std::min(part.x, reach), top = part.y - std::min(part.y, reach);
        const uint32_t right = std::min(part.x + part.width + reach, a_.width);
        for (uint32_t y = top; y < std::min(part.y + part.height + reach, a_.height); ++y) {
            const auto row = marks_.begin() + static_cast<ptrdiff_t>(static_cast<size_t>(y) * a_.width);
            if (std::any_of(row + left, row + right, [](uint8_t mark) { return mark != 0; })) return true;
        }
        return false;
    }

    void fill(const PixelPart& part, std::vector<float>& errors) const
    {
        thread_local LightTile a, b;
        FlipTile tile(filters_);
        for (uint32_t i = 0; i < exposures_.count; ++i) {
            const float step = exposures_.count > 1
                                   ? (exposures_.stop - exposures_.start) / static_cast<float>(exposures_.count - 1)
                                   : 0.0f;
            const float gain = std::exp2(exposures_.start + static_cast<float>(i) * step);
            load(a_, part, gain, a);
            load(b_, part, gain, b);
            const Plane& found = tile.errors(a, b);
            for (uint32_t y = 0; y < part.height; ++y) {
                float* to = &errors[static_cast<size_t>(part.y + y) * a_.width + part.x];
                for (uint32_t x = 0; x < part.width; ++x) to[x] = std::max(to[x], found.row(y)[x]);
            }
        }
    }

    /// Beyond the picture's border its outermost pixels are repeated.
    void load(const Picture& picture, const PixelPart& part, float gain, LightTile& tile) const
    {
        static const StepTable steps;
        const uint32_t reach = filters_.reach;
        for (Plane& plane : tile) plane.resize(part.width + 2 * reach, part.height + 2 * reach);
        const uint32_t width = tile[0].width;
        std::vector<size_t> columns(width);
        for (uint32_t x = 0; x < width; ++x)
            columns[x] = 4 * static_cast<size_t>(
                                 std::clamp<int64_t>(int64_t{part.x} + x - reach, 0, int64_t{picture.width} - 1));
        for (uint32_t y = 0; y < tile[0].height; ++y) {
            const size_t row = std::clamp<int64_t>(int64_t{part.y} + y - reach, 0, int64_t{picture.height} - 1);
            const float* const pixels = &picture.rgba[row * picture.width * 4];
            float *red = tile[0].row(y), *green = tile[1].row(y), *blue = tile[2].row(y);
            for (uint32_t x = 0; x < width; ++x) {
                const float* pixel = pixels + columns[x];
                const float clear = 1.0f - pixel[3];
                const auto light = [&](size_t c) {
                    const float shown = pixel[c] + clear * settings_.background[c];
                    return hdr_ ? toneMapAces(gain * lightOf(shown)) : steps.of(shown);
                };
                red[x] = light(0);
                green[x] = light(1);
                blue[x] = light(2);
            }
        }
    }

    const Picture &a_, &b_;
    const std::vector<uint8_t>& marks_;
    const FlipSettings& settings_;
    FlipFilters filters_;
    bool hdr_;
    size_t columns_, rows_;
    Exposures exposures_;
};

}  // namespace

float toneMapAces(float light)
{
    const float tone = (ACES_A * light * light + ACES_B * light) / (ACES_C * light * light + ACES_D * light + ACES_E);
    return std::isfinite(tone) ? std::clamp(tone, 0.0f, 1.0f) : 1.0f;
}

Exposures exposuresOf(const Picture& reference)
{
    std::vector<float> luminances;
    luminances.reserve(reference.pixelCount());
    for (size_t i = 0; i < reference.rgba.size(); i += 4)
        luminances.push_back(0.2126f * lightOf(reference.rgba[i]) + 0.7152f * lightOf(reference.rgba[i + 1]) +
                             0.0722f * lightOf(reference.rgba[i + 2]));
    const auto median = [&luminances] {
        const auto middle = luminances.begin() + static_cast<ptrdiff_t>(luminances.size() / 2);
        std::ranges::nth_element(luminances, middle);
        return *middle;
    };
    const float brightest = *std::ranges::max_element(luminances);
    if (!(brightest > 0.0f)) return {};
    float middle = median();
    if (!(middle > 0.0f)) {
        std::erase_if(luminances, [](float luminance) { return !(luminance > 0.0f); });
        middle = median();
    }
    // Where the tone mapper gives EXPOSED_TONE: the larger root of p x x + q x + r.
    const double p = double{ACES_A} - EXPOSED_TONE * double{ACES_C}, q = double{ACES_B} - EXPOSED_TONE * double{ACES_D};
    const double r = -EXPOSED_TONE * double{ACES_E};
    const double exposed = (-q + std::sqrt(q * q - 4.0 * p * r)) / (2.0 * p);
    Exposures exposures;
    exposures.start = static_cast<float>(std::log2(exposed / static_cast<double>(brightest)));
    exposures.stop = static_cast<float>(std::log2(exposed / static_cast<double>(middle)));
    const float count = std::max(2.0f, std::ceil(exposures.stop - exposures.start));
    exposures.count = static_cast<uint32_t>(std::min(count, static_cast<float>(MOST_EXPOSURES)));
    return exposures;
}

FlipResult flip(const Picture& a, const Picture& b, const std::vector<uint8_t>& marks, const FlipSettings& settings,
                uint64_t compared, unsigned threads)
{
    if (std::ranges::none_of(marks, [](uint8_t mark) { return mark != 0; })) return {};
    return FlipRun(a, b, marks, settings).run(compared, threads);
}

}  // namespace knuckle
