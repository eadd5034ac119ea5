#include "app/schema/schema.h"

#include <map>

#include "app/schema/schema_check.h"

namespace knuckle {

/// Generated at build time from assets/schema.
const std::map<std::string, std::string_view>& embeddedSchemas();

Schema::Schema(const std::string& file) : text_(embeddedSchemas().at(file)), root_(Json::parse(text_)) {}

const Json& Schema::resolve(const Json& node) const
{
    if (!node.contains("$ref")) return node;
    return root_.at(Json::json_pointer(node["$ref"].get<std::string>().substr(1)));
}

void Schema::expand(Json& root) const
{
    if (!root.is_object()) return;
    for (auto& [key, value] : root.items())
        if (root_["properties"].contains(key)) SchemaCheck::expandString(root_["properties"][key], value);
}

void Schema::complete(JsonFile& file) const
{
    SchemaCheck(*this, file.path).complete(root_, file.root, "");
}

}  // namespace knuckle
