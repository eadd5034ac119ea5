#include "sim/rig/import/gltf/gltf_keys.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/base/errors.h"
#include "sim/rig/import/gltf/gltf_floats.h"

namespace knuckle {

namespace {

using Json = nlohmann::json;

constexpr float JUMP = 1e-4f;               // duration of a jump, over the time between two keys
constexpr float PIECES_PER_SECOND = 60.0f;  // of a curve
constexpr float MOST_PIECES = 600.0f;       // between two keys
constexpr size_t VALUE_LIMIT = 20000000;    // of one sampler

/// Keys under construction.
struct Keys {
    std::vector<float> times, values;
    size_t components = 1;

    void add(float time, const float* value)
    {
        times.push_back(time);
        values.insert(values.end(), value, value + components);
        if (values.size() > VALUE_LIMIT) throw InputError("a clip has more keys than can be read: export fewer");
    }
};

Keys stepKeys(const GltfFloats& times, const GltfFloats& values)
{
    Keys keys{{}, {}, values.components};
    for (size_t k = 0; k < times.values.size(); ++k) {
        const float time = times.values[k];
        if (k > 0) keys.add(time - JUMP * (time - times.values[k - 1]), &values.values[(k - 1) * keys.components]);
        keys.add(time, &values.values[k * keys.components]);
    }
    return keys;
}

/// @param values per key: the slope before it, the value, the slope after it.
Keys splineKeys(const GltfFloats& times, const GltfFloats& values)
{
    Keys keys{{}, {}, values.components};
    const size_t n = keys.components;
    std::vector<float> value(n);
    for (size_t k = 0; k + 1 < times.values.size(); ++k) {
        const float start = times.values[k], span = times.values[k + 1] - start;
        const float* here = &values.values[3 * n * k];
        const float *there = here + 3 * n, *slope = here + 2 * n, *nextSlope = there;
        const float wanted = std::ceil(span * PIECES_PER_SECOND);
        const int pieces = wanted >= 1.0f ? static_cast<int>(std::min(wanted, MOST_PIECES)) : 1;
        for (int piece = 0; piece < pieces; ++piece) {
            const float t = static_cast<float>(piece) / static_cast<float>(pieces), t2 = t * t, t3 = t2 * t;
            for (size_t c = 0; c < n; ++c)
                value[c] = (2 * t3 - 3 * t2 + 1) * here[n + c] + span * (t3 - 2 * t2 + t) * slope[c] +
                           (3 * t2 - 2 * t3) * there[n + c] + span * (t3 - t2) * nextSlope[c];
            keys.add(start + t * span, value.data());
        }
    }
    keys.add(times.values.back(), &values.values[values.values.size() - 2 * n]);
    return keys;
}

void replaceKeys(GltfSource& source, Json& sampler, bool isTurn)
{
    const std::string kind = sampler.value("interpolation", std::string());
    const bool isStep = kind == "STEP";
    if (!isStep && kind != "CUBICSPLINE") return;
    const GltfFloats times = readFloats(source, sampler.at("input").get<size_t>(), false);
    const GltfFloats values = readFloats(source, sampler.at("output").get<size_t>(), isTurn);
    const size_t wanted = times.values.size() * values.components * (isStep ? 1 : 3);
    if (times.values.empty() || values.values.size() < wanted || times.components != 1)
        throw InputError("a clip has fewer values than key times: export the model again");
    const Keys keys = isStep ? stepKeys(times, values) : splineKeys(times, values);
    sampler["input"] = source.addFloats(keys.times, 1, "SCALAR");
    sampler["output"] = source.addFloats(keys.values, keys.components, values.type);
    sampler["interpolation"] = "LINEAR";
}

}  // namespace

void supplyLinearKeys(GltfSource& source)
{
    Json animations = source.list("animations");
    for (Json& animation : animations) {
        std::map<size_t, bool> isTurn;  // by sampler; weights of shapes are not changed
        for (const Json& channel : animation.value("channels", Json::array())) {
            const std::string path = channel.at("target").value("path", std::string());
            if (path == "rotation" || path == "translation" || path == "scale")
                isTurn[channel.at("sampler").get<size_t>()] = path == "rotation";
        }
        for (const auto& [sampler, turns] : isTurn) replaceKeys(source, animation.at("samplers").at(sampler), turns);
    }
    if (animations != source.list("animations")) source.root["animations"] = std::move(animations);
}

}  // namespace knuckle
