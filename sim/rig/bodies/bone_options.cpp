#include "sim/rig/bodies/bone_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/errors.h"
#include "sim/rig/anatomy/names/name_pattern.h"

namespace knuckle {

namespace {

bool fits(const Bone& bone, const std::string& pattern)
{
    return bone.name == pattern || matchesPattern(bone.name, pattern);
}

/// @param what "joint for bone"
void checkPattern(const Model& model, const char* what, const std::string& pattern)
{
    if (std::ranges::none_of(model.bones, [&](const Bone& bone) { return fits(bone, pattern); }))
        throw InputError(fmt::format("{} '{}': the model '{}' has no bone of that name", what, pattern, model.name));
}

}  // namespace

void checkBoneNames(const Model& model, const ArticulationOptions& options)
{
    const auto checkNames = [&](const auto& overrides) {
        for (const auto& entry : overrides) checkPattern(model, "joint for bone", entry.first);
    };
    checkNames(options.types);
    checkNames(options.axes);
    checkNames(options.limits);
    checkNames(options.strengths);
    for (const std::string& pattern : options.keep) checkPattern(model, "body to keep for bone", pattern);
    for (const std::string& pattern : options.merge) checkPattern(model, "bone to merge", pattern);
}

std::map<uint32_t, BoneRole> rolesWanted(const Model& model, const ArticulationOptions& options)
{
    std::map<uint32_t, BoneRole> roles;
    const auto want = [&](const std::vector<std::string>& patterns, BoneRole role) {
        for (uint32_t b = 0; b < model.bones.size(); ++b)
            if (std::ranges::any_of(patterns,
                                    [&](const std::string& pattern) { return fits(model.bones[b], pattern); }))
                roles[b] = role;
    };
    want(options.keep, BoneRole::Limb);
    want(options.merge, BoneRole::Attached);
    return roles;
}

}  // namespace knuckle
