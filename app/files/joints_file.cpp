#include "app/files/joints_file.h"

#include "app/json/fields.h"
#include "app/json/joint_limits.h"
#include "app/schema/schema.h"

namespace knuckle {

void readJoints(const std::string& path, ArticulationOptions& options)
{
    static const Schema schema("joints.schema.json");
    JsonFile file = readJsonFile(path);
    schema.complete(file);
    for (const auto& [bone, json] : file.root.items()) {
        const Json type = json.is_string() ? json : json.value("type", Json());
        if (type.is_string()) readValue(type, options.types[bone]);
        if (!json.is_object()) continue;
        if (const JointLimits limits = readLimits(json["limits"]); limits.any()) options.limits[bone] = limits;
        if (const JointStrength strength = readStrength(json); strength.tears()) options.strengths[bone] = strength;
        if (!json.contains("axis")) continue;
        Vector3f axis;
        readValue(json["axis"], axis);
        if (axis.norm() < 1e-3f) failAt(path, "/" + bone + "/axis", "must not be zero");
        options.axes[bone] = axis.normalized();
    }
}

}  // namespace knuckle
