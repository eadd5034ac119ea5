#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/schema/schema.h"

namespace knuckle {

namespace {

/// The heading's anchor, as Git forges generate it.
std::string anchorOf(const std::string& title)
{
    std::string anchor;
    for (const char c : title) {
        if (std::isalnum(static_cast<unsigned char>(c))) anchor += static_cast<char>(std::tolower(c));
        if (c == ' ' || c == '-') anchor += '-';
    }
    return anchor;
}

bool isSection(const Json& node)
{
    return node.contains("title") && node.value("type", "") == "object";
}

class MarkdownPage {
public:
    explicit MarkdownPage(const Schema& schema) : schema_(schema) {}

    std::string text()
    {
        const Json& root = schema_.root();
        text_ = fmt::format("# {} files\n\n<!-- Made by `knuckle schema --markdown` from assets/schema; do not edit. "
                            "-->\n\n{}\n\n",
                            root["title"].get<std::string>(), root["description"].get<std::string>());
        addTable(root);
        for (const auto& [name, node] : root["definitions"].items()) {
            if (!isSection(node)) continue;
            text_ += fmt::format("\n## {}\n\n{}\n\n", node["title"].get<std::string>(),
                                 node["description"].get<std::string>());
            addTable(node);
        }
        return text_;
    }

private:
    void addTable(const Json& node)
    {
        text_ += "| field | value | default | meaning |\n| --- | --- | --- | --- |\n";
        if (!node.contains("properties")) return;
        for (const auto& [name, property] : node["properties"].items()) {
            const Json& field = schema_.resolve(property);
            text_ += fmt::format("| `{}` | {} | {} | {} |\n", name, valueText(property), defaultText(node, name, field),
                                 field.value("description", ""));
        }
    }

    std::string defaultText(const Json& parent, const std::string& name, const Json& field) const
    {
        const Json required = parent.value("required", Json::array());
        if (std::find(required.begin(), required.end(), name) != required.end()) return "required";
        if (field.contains("x-default-from")) {
            return fmt::format("{}, or `{}`", field["default"].dump(), field["x-default-from"].get<std::string>());
        }
        return field.contains("default") ? fmt::format("`{}`", field["default"].dump()) : "";
    }

    std::string valueText(const Json& property) const
    {
        const Json& node = schema_.resolve(property);
        if (node.empty()) return "any value";
        if (node.contains("const")) return fmt::format("`{}`", node["const"].dump());
        if (node.contains("oneOf")) {
            std::vector<std::string> words;
            for (const Json& alternative : node["oneOf"]) words.push_back(valueText(alternative));
            return fmt::format("{}", fmt::join(words, ", or "));
        }
        if (isSection(node)) {
            const std::string title = node["title"];
            return fmt::format("[{}](#{})", title, anchorOf(title));
        }
        if (node["type"] == "array") return arrayText(node);
        if (node["type"] == "object") return "names of " + valueText(node["additionalProperties"]);
        return scalarText(node) + unitText(node);
    }

    std::string arrayText(const Json& node) const
    {
        const Json count = node.value("minItems", Json());
        const std::string size = !count.is_null() && count == node.value("maxItems", Json()) ? count.dump() : "list";
        return fmt::format("{} of {}{}", size, valueText(node["items"]), unitText(node));
    }

    static std::string scalarText(const Json& node)
    {
        if (node.contains("enum")) {
            std::vector<std::string> words;
            for (const Json& word : node["enum"]) words.push_back(fmt::format("`{}`", word.dump()));
            return fmt::format("{}", fmt::join(words, ", "));
        }
        std::string range;
        if (node.contains("minimum")) range += fmt::format(", ≥ {}", node["minimum"].dump());
        if (node.contains("exclusiveMinimum")) range += fmt::format(", > {}", node["exclusiveMinimum"].dump());
        if (node.contains("maximum")) range += fmt::format(", ≤ {}", node["maximum"].dump());
        return node["type"].get<std::string>() + range;
    }

    static std::string unitText(const Json& node)
    {
        return node.contains("x-unit") ? fmt::format(" [{}]", node["x-unit"].get<std::string>()) : "";
    }

    const Schema& schema_;
    std::string text_;
};

}  // namespace

std::string schemaMarkdown(const Schema& schema)
{
    return MarkdownPage(schema).text();
}

}  // namespace knuckle
