#include "sim/rig/import/gltf/joint_names.h"

#include <fmt/format.h>

#include <set>

namespace knuckle {

namespace {

using Json = nlohmann::json;

std::string nameOf(const Json& node)
{
    const auto name = node.find("name");
    return name != node.end() && name->is_string() ? name->get<std::string>() : std::string();
}

/// The nodes that need distinct names.
std::set<size_t> namedNodes(const Json& gltf)
{
    std::set<size_t> nodes;
    for (const Json& skin : gltf.value("skins", Json::array()))
        for (const Json& joint : skin.at("joints")) nodes.insert(joint.get<size_t>());
    for (const Json& animation : gltf.value("animations", Json::array()))
        for (const Json& channel : animation.value("channels", Json::array()))
            if (channel.at("target").contains("node")) nodes.insert(channel["target"]["node"].get<size_t>());
    return nodes;
}

}  // namespace

std::map<std::string, std::string> nameJoints(Json& gltf)
{
    std::map<std::string, std::string> originals;
    if (!gltf.contains("nodes")) return originals;
    std::set<std::string> names;
    for (const Json& node : gltf["nodes"]) names.insert(nameOf(node));
    std::map<std::string, int> seen;
    for (const size_t joint : namedNodes(gltf)) {
        Json& node = gltf["nodes"].at(joint);
        const std::string name = nameOf(node);
        if (name.empty() || ++seen[name] == 1) continue;
        int number = seen[name];
        std::string unique = fmt::format("{}#{}", name, number);
        while (names.contains(unique)) unique = fmt::format("{}#{}", name, ++number);
        names.insert(unique);
        originals[unique] = name;
        node["name"] = unique;
    }
    return originals;
}

}  // namespace knuckle
