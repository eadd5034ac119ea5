#include "sim/actor/clips/bone_match.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "sim/actor/bodies/articulate.h"

namespace knuckle {

namespace {

/// "mixamorig:LeftArm" and "leftarm" are one name.
std::string plainName(const std::string& name)
{
    std::string plain;
    for (const char c : name.substr(name.rfind(':') + 1))  // npos + 1 is 0
        if (std::isalnum(static_cast<unsigned char>(c))) plain += static_cast<char>(std::tolower(c));
    return plain;
}

/// A part and its side.
using PartKey = std::pair<BodyPart, int>;

struct Named {
    std::string name;
    int32_t parent = -1;
};

/// Of each part, in order from the root: several of a spine.
std::map<PartKey, std::vector<uint32_t>> partsOf(const std::vector<Named>& all)
{
    std::map<PartKey, std::vector<uint32_t>> parts;
    for (uint32_t b = 0; b < all.size(); ++b) {
        const auto child = std::ranges::find(all, static_cast<int32_t>(b), &Named::parent);
        const BodyPart part = partFromName(all[b].name, all[b].parent < 0 ? "" : all[all[b].parent].name,
                                           child == all.end() ? "" : child->name);
        if (part != BodyPart::Other && part != BodyPart::Finger) parts[{part, sideFromName(all[b].name)}].push_back(b);
    }
    return parts;
}

std::vector<Named> namesOf(const Actor& actor)
{
    std::vector<Named> names;
    for (uint32_t b = 0; b < actor.bodies.size(); ++b)
        names.push_back({actor.bodies[b].isCross ? std::string() : actor.bodies[b].name, parentBody(actor, b)});
    return names;
}

}  // namespace

std::vector<uint32_t> matchBones(const Actor& actor, const Model& source)
{
    std::vector<Named> bones;
    std::map<std::string, uint32_t> byName;
    for (const Bone& bone : source.bones) {
        byName.try_emplace(plainName(bone.name), static_cast<uint32_t>(bones.size()));
        bones.push_back({bone.name, bone.parent});
    }
    const std::vector<Named> bodies = namesOf(actor);
    std::vector<uint32_t> match(bodies.size(), NO_INDEX);
    for (uint32_t b = 0; b < bodies.size(); ++b)
        if (const auto found = byName.find(plainName(bodies[b].name)); found != byName.end() && !bodies[b].name.empty())
            match[b] = found->second;
    const auto theirs = partsOf(bones);
    for (const auto& [part, ours] : partsOf(bodies)) {
        const auto found = theirs.find(part);
        if (found == theirs.end()) continue;
        // The last of both are alike: the chest, the wrist.
        const size_t n = ours.size(), m = found->second.size();
        for (size_t i = 0; i < n; ++i)
            if (match[ours[i]] == NO_INDEX) match[ours[i]] = found->second[((i + 1) * m + n - 1) / n - 1];
    }
    return match;
}

}  // namespace knuckle
