#pragma once

#include <vector>

#include "app/json/json.h"
#include "app/serve/changes/live_fields.h"
#include "app/serve/hand.h"

namespace knuckle {

/// As viewers get it.
inline Json wordsOf(const Picked& picked)
{
    const Eigen::Vector3f& place = picked.place;
    return {{"name", picked.name},
            {"isBody", picked.body != NO_INDEX},
            {"canBePulled", picked.canBePulled()},
            {"place", {place.x(), place.y(), place.z()}},
            {"depth", picked.depth}};
}

/// A list, in their order.
inline Json wordsOf(const std::vector<LiveField>& fields)
{
    Json all = Json::array();
    for (const LiveField& field : fields)
        all.push_back({{"name", field.name},
                       {"value", field.value},
                       {"least", field.least},
                       {"most", field.most},
                       {"unit", field.unit}});
    return all;
}

}  // namespace knuckle
