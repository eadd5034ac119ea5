#pragma once

#include <string>
#include <vector>

#include "app/schema/schema.h"

namespace knuckle {

/// One walk over a document along its schema: checks each value and fills in the defaults.
class SchemaCheck {
public:
    SchemaCheck(const Schema& schema, std::string path) : schema_(schema), path_(std::move(path)) {}

    /// Checks `value`, found at the JSON pointer `pointer`, against `node`. @throws InputError for the first fault.
    void complete(const Json& node, Json& value, const std::string& pointer) const;

    /// Makes an object of a string if the node names its field (`x-string-means`).
    static void expandString(const Json& node, Json& value);

private:
    void completeObject(const Json& node, Json& value, const std::string& pointer) const;
    void fillDefaults(const Json& node, Json& value) const;
    void requireOneOf(const Json& properties, const Json& value, const std::string& pointer) const;
    void checkKeys(const Json& node, const Json& value, const std::string& pointer) const;
    void completeArray(const Json& node, Json& value, const std::string& pointer) const;
    void checkType(const Json& node, Json& value, const std::string& pointer) const;
    void checkRange(const Json& node, const Json& value, const std::string& pointer) const;
    void checkWord(const Json& node, const Json& value, const std::string& pointer) const;
    const Json& choose(const Json& node, const Json& value, const std::string& pointer) const;
    [[noreturn]] void fail(const std::string& pointer, const std::string& message) const;

    const Schema& schema_;
    std::string path_;
};

/// The word for a value's JSON type: "a string", "an array of 2".
std::string kindOf(const Json& value);

}  // namespace knuckle
