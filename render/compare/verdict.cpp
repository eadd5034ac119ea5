#include "render/compare/verdict.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace knuckle {

namespace {

/// A limit of whole steps must not hang on the last bits of floats.
constexpr double LAST_BITS = 1e-4;

std::string count(uint64_t pixels, const char* what)
{
    return fmt::format("{} {}{}", pixels, what, pixels == 1 ? "" : "s");
}

std::string changedWords(const PictureComparison& comparison)
{
    return fmt::format("{} of {} pixels {} by more than {:g} of 255", comparison.differences.changed,
                       comparison.compared, comparison.differences.changed == 1 ? "differs" : "differ",
                       comparison.threshold);
}

void checkChanged(const PictureComparison& comparison, const CompareLimits& limits, std::vector<std::string>& reasons)
{
    const uint64_t changed = comparison.differences.changed;
    const double share = static_cast<double>(changed) / static_cast<double>(std::max<uint64_t>(1, comparison.compared));
    if (limits.pixels && changed > *limits.pixels)
        reasons.push_back(fmt::format("{} ({} may)", changedWords(comparison), *limits.pixels));
    else if (limits.share && share > *limits.share)
        reasons.push_back(fmt::format("{} ({:.0f} may, {} %)", changedWords(comparison),
                                      std::floor(*limits.share * static_cast<double>(comparison.compared)),
                                      shortNumber(100.0 * *limits.share)));
}

}  // namespace

std::string shortNumber(double value)
{
    return fmt::format("{:.4g}", value);
}

std::string boxWords(const PixelBox& box)
{
    return fmt::format("at {},{}, {} x {}", box.x, box.y, box.width, box.height);
}

Verdict judge(const PictureComparison& comparison, const CompareLimits& limits)
{
    Verdict verdict;
    if (!comparison.sameSize()) {
        verdict.reasons.push_back(fmt::format("{} x {} against {} x {}", comparison.width, comparison.height,
                                              comparison.secondWidth, comparison.secondHeight));
    } else {
        checkChanged(comparison, limits, verdict.reasons);
        const auto check = [&](double value, const std::optional<double>& limit, const std::string& words) {
            if (limit && value > *limit + (*limit > 0.0 ? LAST_BITS : 0.0))
                verdict.reasons.push_back(
                    fmt::format("{} {} (at most {})", words, shortNumber(value), shortNumber(*limit)));
        };
        check(comparison.differences.mean, limits.mean, "mean difference of 255");
        check(comparison.differences.max, limits.largest, "largest difference of 255");
        check(comparison.tile.score, limits.tile, fmt::format("the tile {} scores", boxWords(comparison.tile.box)));
        check(comparison.flip.mean, limits.flip, "mean FLIP");
        if (limits.ssim && comparison.ssim.mean < *limits.ssim)
            verdict.reasons.push_back(fmt::format("mean SSIM {} (at least {})", shortNumber(comparison.ssim.mean),
                                                  shortNumber(*limits.ssim)));
    }
    verdict.equal = verdict.reasons.empty();
    return verdict;
}

std::string verdictLine(const PictureComparison& comparison, const Verdict& verdict)
{
    const Differences& differences = comparison.differences;
    const std::string ignored = comparison.antialiased > 0
                                    ? fmt::format("; {} of edges ignored", count(comparison.antialiased, "pixel"))
                                    : "";
    if (!verdict.equal) return fmt::format("different: {}{}", fmt::join(verdict.reasons, "; "), ignored);
    if (comparison.identical())
        return fmt::format("equal: {} compared, none differs{}", count(comparison.compared, "pixel"), ignored);
    return fmt::format("equal: {} of {} pixels differ, {} by more than {:g} of 255; mean {}, largest {}, FLIP {}{}",
                       differences.differing, comparison.compared, differences.changed, comparison.threshold,
                       shortNumber(differences.mean), shortNumber(differences.max), shortNumber(comparison.flip.mean),
                       ignored);
}

std::string placesLine(const PictureComparison& comparison)
{
    if (comparison.places.empty()) return "";
    const std::string box = boxWords(comparison.places.front().box);
    if (comparison.places.size() == 1) return fmt::format("the difference is in 1 place, {}", box);
    return fmt::format("the difference is in {} places, the largest {}", comparison.places.size(), box);
}

}  // namespace knuckle
