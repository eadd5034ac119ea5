#include "app/scene/colliders/scene_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/json/fields.h"
#include "app/scene/scene_places.h"

namespace knuckle {

namespace {

constexpr float RATE = 60.0f;  // keys of the clip [1/s]

/// A place at a time: an offset from the start [m], and angles about fixed x, y, z [degrees].
struct MotionKey {
    float time = 0.0f;
    Eigen::Matrix<float, 6, 1> value = Eigen::Matrix<float, 6, 1>::Zero();
};

std::vector<MotionKey> readKeys(const SceneEntry& entry)
{
    std::vector<MotionKey> keys;
    const Json& json = entry.json["motion"]["keys"];
    for (size_t i = 0; i < json.size(); ++i) {
        MotionKey key;
        key.time = json[i]["time"];
        Vector3f position, angles;
        readValue(json[i]["position"], position);
        readValue(json[i]["rotation"], angles);
        key.value << position, angles;
        if (!keys.empty() && key.time <= keys.back().time)
            entry.fail(fmt::format("/motion/keys/{}/time", i), "must be after that of the key before");
        keys.push_back(key);
    }
    if (!keys.empty() && keys.front().time != 0.0f)
        entry.fail("/motion/keys/0/time", "must be 0: a motion begins when the film does");
    return keys;
}

/// The value between keys: on a straight line, or on a curve whose speed at each key follows from its neighbours and
/// which rests at both ends.
Eigen::Matrix<float, 6, 1> valueAt(const std::vector<MotionKey>& keys, float time, bool smooth)
{
    size_t k = 0;
    while (k + 2 < keys.size() && keys[k + 1].time <= time) ++k;
    if (keys.size() == 1) return keys[0].value;
    const MotionKey &a = keys[k], &b = keys[k + 1];
    const float span = b.time - a.time, t = std::clamp((time - a.time) / span, 0.0f, 1.0f);
    if (!smooth) return a.value + t * (b.value - a.value);
    const auto speedAt = [&](size_t i) -> Eigen::Matrix<float, 6, 1> {
        if (i == 0 || i + 1 == keys.size()) return Eigen::Matrix<float, 6, 1>::Zero();
        return (keys[i + 1].value - keys[i - 1].value) / (keys[i + 1].time - keys[i - 1].time);
    };
    const float s = 1 - t;
    return s * s * (1 + 2 * t) * a.value + t * t * (1 + 2 * s) * b.value +
           span * s * t * (s * speedAt(k) - t * speedAt(k + 1));
}

}  // namespace

bool hasMotion(const Json& entry)
{
    return entry.contains("motion") && !entry["motion"]["keys"].empty();
}

ClipPlay readMotion(const SceneEntry& entry, const std::string& name)
{
    const std::vector<MotionKey> keys = readKeys(entry);
    const bool smooth = entry.json["motion"]["path"] == "smooth";
    const float length = keys.back().time;
    const auto count = static_cast<uint32_t>(std::max(std::round(length * RATE), 1.0f));
    BodyClip clip{name, length > 0 ? static_cast<float>(count) / length : RATE, 1};
    for (uint32_t k = 0; k <= count; ++k) {
        const auto value = valueAt(keys, length * static_cast<float>(k) / static_cast<float>(count), smooth);
        clip.roots.emplace_back(value.head<3>());
        clip.turns.push_back(rotationOf(value.tail<3>()));
        if (k > 0 && clip.turns[k].dot(clip.turns[k - 1]) < 0) clip.turns[k].coeffs() *= -1;
    }
    ClipPlay play;
    play.loop = entry.json["motion"]["loop"];
    play.clip = entry.context.builder.addClip(std::move(clip));
    return play;
}

ClipPlay readObjectMotion(const ObjectEntry& entry)
{
    if (entry.json["fixed"].get<bool>()) entry.fail("/motion", "is for what is not fixed; take one of them away");
    if (!entry.velocity.isZero() || !entry.spin.isZero())
        entry.fail("/motion", "says how fast it is; take `velocity` and `spin` away");
    return readMotion(entry, entry.name);
}

}  // namespace knuckle
