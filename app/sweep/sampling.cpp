#include "app/sweep/sampling.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace knuckle {

namespace {

/// Calls make(low, high) for the ends, or for those of each component.
template <typename Make>
Json between(const SweepField& field, const Make& make)
{
    if (!field.low.is_array()) return make(field.low.get<double>(), field.high.get<double>());
    Json vector = Json::array();
    for (size_t k = 0; k < field.low.size(); ++k)
        vector.push_back(make(field.low[k].get<double>(), field.high[k].get<double>()));
    return vector;
}

/// From 0 to below 1, of the generator's raw numbers, which are the same everywhere.
double fraction(std::mt19937_64& random)
{
    return std::ldexp(static_cast<double>(random() >> 11), -53);
}

/// Rounded once, whether the processor fuses products and sums or not.
double mix(double low, double high, double share)
{
    return std::fma(high - low, share, low);
}

Json drawValue(const SweepField& field, std::mt19937_64& random)
{
    if (!field.values.empty()) {
        const double place = std::floor(fraction(random) * static_cast<double>(field.values.size()));
        return field.values[static_cast<size_t>(place)];
    }
    return between(field, [&](double low, double high) -> Json {
        if (!field.whole) return mix(low, high, fraction(random));
        return static_cast<int64_t>(std::min(high, std::floor(mix(low, high + 1.0, fraction(random)))));
    });
}

}  // namespace

bool isWhole(double number)
{
    return std::nearbyint(number) == number && std::abs(number) <= 9e15;
}

std::vector<Json> evenValues(const SweepField& field, uint64_t count)
{
    std::vector<Json> values;
    for (uint64_t k = 0; k < count; ++k)
        values.push_back(between(field, [&](double low, double high) -> Json {
            if (k + 1 == count) return field.whole ? Json(static_cast<int64_t>(high)) : Json(high);
            const double value = mix(low, high, static_cast<double>(k) / static_cast<double>(count - 1));
            return field.whole ? Json(static_cast<int64_t>(std::nearbyint(value))) : Json(value);
        }));
    return values;
}

uint64_t combinationCount(const SweepPlan& plan)
{
    if (plan.randomRuns) return *plan.randomRuns;
    uint64_t count = 1;
    for (const SweepField& field : plan.fields) count = std::min(count * field.values.size(), MAX_RUNS + 1);
    return count;
}

std::vector<std::vector<Json>> sampleFields(const SweepPlan& plan)
{
    std::vector<std::vector<Json>> runs(combinationCount(plan));
    std::mt19937_64 random(plan.seed);
    for (uint64_t run = 0; run < runs.size(); ++run) {
        runs[run].resize(plan.fields.size());
        uint64_t rest = run;
        for (size_t k = plan.fields.size(); k-- > 0 && !plan.randomRuns;) {
            const std::vector<Json>& values = plan.fields[k].values;
            runs[run][k] = values[rest % values.size()];
            rest /= values.size();
        }
        for (size_t k = 0; k < plan.fields.size() && plan.randomRuns; ++k)
            runs[run][k] = drawValue(plan.fields[k], random);
    }
    return runs;
}

}  // namespace knuckle
