#include "app/schema/schema_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace knuckle {

namespace {

std::vector<std::string> keysOf(const Json& object)
{
    std::vector<std::string> keys;
    for (const auto& [key, value] : object.items()) keys.push_back(key);
    return keys;
}

bool matchesType(const std::string& type, const Json& value)
{
    if (type == "number") return value.is_number();
    if (type == "integer") return value.is_number() && std::nearbyint(value.get<double>()) == value.get<double>();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "array") return value.is_array();
    return value.is_object();
}

/// A description of values of this schema: "a number [m]", "an array of 3 numbers [m/s]".
std::string expectation(const Schema& schema, const Json& node)
{
    const std::string type = node["type"];
    const std::string unit = node.contains("x-unit") ? fmt::format(" [{}]", node["x-unit"].get<std::string>()) : "";
    if (type == "array" && node.contains("minItems") && node["minItems"] == node.value("maxItems", -1)) {
        return fmt::format("an array of {} {}s{}", node["minItems"].get<int>(),
                           schema.resolve(node["items"])["type"].get<std::string>(), unit);
    }
    if (type == "boolean") return "true or false";
    const bool vowel = type == "array" || type == "integer" || type == "object";
    return fmt::format("{} {}{}", vowel ? "an" : "a", type, unit);
}

/// The value, shortened for a message.
std::string shown(const Json& value)
{
    const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    return text.size() <= 40 ? text : text.substr(0, 37) + "...";
}

/// Encodes a key for a JSON pointer.
std::string escaped(const std::string& key)
{
    std::string out;
    for (const char c : key) out += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return out;
}

/// Whether a rule of `x-defaults-if` applies to this object.
bool applies(const Json& rule, const Json& object)
{
    const auto isGiven = [&](const Json& key) { return object.contains(key.get<std::string>()); };
    if (rule.contains("given") && std::ranges::none_of(rule["given"], isGiven)) return false;
    if (!rule.contains("equal")) return true;
    const auto& equal = rule["equal"].items();
    return std::all_of(equal.begin(), equal.end(),
                       [&](const auto& field) { return object.value(field.key(), Json()) == field.value(); });
}

void fillDefaultsIf(const Json& node, Json& object)
{
    if (!node.contains("x-defaults-if")) return;
    for (const Json& rule : node["x-defaults-if"]) {
        if (!applies(rule, object)) continue;
        for (const auto& [key, value] : rule["defaults"].items())
            if (!object.contains(key)) object[key] = value;
    }
}

}  // namespace

std::string kindOf(const Json& value)
{
    if (value.is_array()) return fmt::format("an array of {}", value.size());
    if (value.is_object()) return "an object";
    if (value.is_null()) return "null";
    return fmt::format("{} {}", shown(value), value.is_string() ? "(a string)" : value.is_number() ? "(a number)" : "");
}

void SchemaCheck::expandString(const Json& node, Json& value)
{
    if (value.is_string() && node.contains("x-string-means")) value = Json{{node["x-string-means"], value}};
}

void SchemaCheck::complete(const Json& schemaNode, Json& value, const std::string& pointer) const
{
    const Json& given = schema_.resolve(schemaNode);
    if (given.empty()) return;  // {} allows anything
    if (value.is_string() && given.contains("x-string-means")) {
        checkWord(choose(given, value, pointer), value, pointer);
        expandString(given, value);
    }
    const Json& node = choose(given, value, pointer);
    if (node.contains("const")) return;  // it has selected this alternative
    checkType(node, value, pointer);
    if (value.is_object()) completeObject(node, value, pointer);
    if (value.is_array()) completeArray(node, value, pointer);
    if (value.is_number()) checkRange(node, value, pointer);
    if (value.is_string()) checkWord(node, value, pointer);
}

/// The alternative of a oneOf that fits the value: by JSON type, then by the properties that are const.
const Json& SchemaCheck::choose(const Json& node, const Json& value, const std::string& pointer) const
{
    if (!node.contains("oneOf")) return node;
    std::vector<const Json*> left;
    std::string expected;
    for (const Json& alternative : node["oneOf"]) {
        const Json& resolved = schema_.resolve(alternative);
        const std::string words = expectation(schema_, resolved);
        if (expected.find(words) == std::string::npos) expected += (expected.empty() ? "" : " or ") + words;
        if (matchesType(resolved["type"], value)) left.push_back(&resolved);
    }
    if (left.empty()) fail(pointer, fmt::format("is {}, must be {}", kindOf(value), expected));
    for (const char* key : {"type", "shape"}) {
        std::vector<const Json*> matching;
        std::vector<std::string> words;
        for (const Json* alternative : left) {
            const Json properties = alternative->value("properties", Json::object());
            if (!properties.contains(key) || !properties[key].contains("const")) continue;
            const std::string word = properties[key]["const"];
            if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
            if (value.contains(key) && value[key] == word) matching.push_back(alternative);
        }
        if (words.empty()) continue;
        if (!value.contains(key)) fail(pointer, fmt::format("\"{}\" is missing; {}", key, suggestion("", words)));
        if (matching.empty()) {
            const std::string word = value[key].is_string() ? value[key].get<std::string>() : "";
            fail(fmt::format("{}/{}", pointer, key),
                 fmt::format("{} is unknown; {}", shown(value[key]), suggestion(word, words)));
        }
        left = matching;
    }
    return *left.front();
}

void SchemaCheck::checkType(const Json& node, Json& value, const std::string& pointer) const
{
    const std::string type = node["type"];
    if (!matchesType(type, value)) {
        fail(pointer, fmt::format("is {}, must be {}", kindOf(value), expectation(schema_, node)));
    }
    if (type == "integer" && value.is_number_float()) {
        const double number = value.get<double>();
        if (std::abs(number) > 9e15) fail(pointer, fmt::format("{} is too large", shown(value)));
        value = static_cast<int64_t>(number);
    }
}

void SchemaCheck::completeObject(const Json& node, Json& value, const std::string& pointer) const
{
    const Json& properties = node.contains("properties") ? node["properties"] : Json::object();
    requireOneOf(properties, value, pointer);
    fillDefaultsIf(node, value);
    checkKeys(node, value, pointer);
    fillDefaults(node, value);
    for (auto& [key, child] : value.items()) {
        const Json& childNode = properties.contains(key) ? properties[key] : node["additionalProperties"];
        complete(childNode, child, fmt::format("{}/{}", pointer, escaped(key)));
    }
}

/// Checks only the document's own fields: those that defaults fill in may be empty.
void SchemaCheck::requireOneOf(const Json& properties, const Json& value, const std::string& pointer) const
{
    for (const auto& [key, child] : value.items()) {
        if (!child.is_object() || !properties.contains(key)) continue;
        const Json& node = schema_.resolve(properties[key]);
        if (!node.contains("x-needs-one-of")) continue;
        const auto isGiven = [&object = child](const Json& field) {
            return object.value(field.get<std::string>(), Json("")) != Json("");
        };
        if (std::ranges::none_of(node["x-needs-one-of"], isGiven))
            fail(fmt::format("{}/{}", pointer, escaped(key)), node["x-remedy"]);
    }
}

void SchemaCheck::checkKeys(const Json& node, const Json& value, const std::string& pointer) const
{
    const Json& properties = node.contains("properties") ? node["properties"] : Json::object();
    const bool open = node.contains("additionalProperties") && node["additionalProperties"].is_object();
    for (const auto& [key, child] : value.items()) {
        if (open || properties.contains(key)) continue;
        fail(fmt::format("{}/{}", pointer, escaped(key)),
             fmt::format("unknown field; {}", suggestion(key, keysOf(properties))));
    }
    if (!node.contains("required")) return;
    for (const Json& key : node["required"]) {
        const std::string name = key;
        if (value.contains(name)) continue;
        const Json& child = schema_.resolve(properties[name]);
        const std::string remedy = child.contains("enum")
                                       ? suggestion("", child["enum"].get<std::vector<std::string>>())
                                       : fmt::format("add it: {}", child["description"].get<std::string>());
        fail(pointer, fmt::format("\"{}\" is missing; {}", name, remedy));
    }
}

void SchemaCheck::fillDefaults(const Json& node, Json& value) const
{
    if (!node.contains("properties")) return;
    for (const auto& [key, child] : node["properties"].items()) {
        const Json& childNode = schema_.resolve(child);
        if (value.contains(key) || !childNode.contains("default")) continue;
        const std::string source = childNode.value("x-default-from", "");
        value[key] = value.contains(source) ? value[source] : childNode["default"];
    }
}

void SchemaCheck::completeArray(const Json& node, Json& value, const std::string& pointer) const
{
    const size_t least = node.value("minItems", size_t{0});
    const size_t most = node.value("maxItems", std::numeric_limits<size_t>::max());
    if (value.size() < least || value.size() > most) {
        const std::string rule = least == most          ? expectation(schema_, node)
                                 : value.size() < least ? fmt::format("at least {}", least)
                                                        : fmt::format("at most {}", most);
        fail(pointer, fmt::format("is {}, must be {}", kindOf(value), rule));
    }
    for (size_t i = 0; i < value.size(); ++i) complete(node["items"], value[i], fmt::format("{}/{}", pointer, i));
}

void SchemaCheck::checkRange(const Json& node, const Json& value, const std::string& pointer) const
{
    const std::string unit = node.contains("x-unit") ? fmt::format(" [{}]", node["x-unit"].get<std::string>()) : "";
    const double number = value.get<double>();
    // Values are stored as floats.
    if (std::abs(number) > double{std::numeric_limits<float>::max()})
        fail(pointer, fmt::format("{} is too large", shown(value)));
    const auto limit = [&](const char* key) { return node[key].get<double>(); };
    if (node.contains("minimum") && number < limit("minimum")) {
        fail(pointer, fmt::format("{} is below the minimum {}{}", shown(value), limit("minimum"), unit));
    }
    if (node.contains("exclusiveMinimum") && number <= limit("exclusiveMinimum")) {
        fail(pointer, fmt::format("{} must be above {}{}", shown(value), limit("exclusiveMinimum"), unit));
    }
    if (node.contains("maximum") && number > limit("maximum")) {
        fail(pointer, fmt::format("{} is above the maximum {}{}", shown(value), limit("maximum"), unit));
    }
}

void SchemaCheck::checkWord(const Json& node, const Json& value, const std::string& pointer) const
{
    if (value.get<std::string>().size() < node.value("minLength", size_t{0})) fail(pointer, "must not be empty");
    if (!node.contains("enum")) return;
    const std::vector<std::string> words = node["enum"];
    const std::string word = value;
    if (std::find(words.begin(), words.end(), word) != words.end()) return;
    const Json refused = node.value("x-refused", Json::object());
    if (refused.contains(word)) fail(pointer, fmt::format("{} {}", shown(value), refused[word].get<std::string>()));
    fail(pointer, fmt::format("{} is unknown; {}", shown(value), suggestion(word, words)));
}

void SchemaCheck::fail(const std::string& pointer, const std::string& message) const
{
    failAt(path_, pointer, message);
}

}  // namespace knuckle
