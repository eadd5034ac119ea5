#pragma once

#include <string>
#include <string_view>

#include "app/json/json.h"

namespace knuckle {

/// A published JSON Schema (draft 7) that is part of the program.
///
/// Supported: type, const, enum, minimum, maximum, exclusiveMinimum, items, minItems, maxItems, minLength, properties,
/// required, additionalProperties, $ref to a definition, oneOf whose alternatives differ by JSON type or by `const`
/// properties, default; and the project's own `x-unit` (shown in documents and messages), `x-default-from` (a sibling
/// whose value, if given, is the default), `x-string-means` (the field of an object that a string stands for),
/// `x-defaults-if` (defaults that precede the others if the document has one of the fields `given`, or all of `equal`
/// have these values; without a condition always), and `x-needs-one-of` (an object in the document must have one of
/// these fields, not empty; else `x-remedy` is the message), and `x-refused` (words that users may expect beside those
/// of `enum`, and what is said of each).
class Schema {
public:
    /// @param file name below assets/schema, "scene.schema.json".
    explicit Schema(const std::string& file);

    const Json& root() const { return root_; }
    std::string_view text() const { return text_; }
    /// `node`, or the definition that its $ref names.
    const Json& resolve(const Json& node) const;

    /// Replaces strings that stand for objects by those, among the document's fields.
    void expand(Json& root) const;
    /// Checks the document and fills in every default. @throws InputError for the first fault, one line with its path.
    void complete(JsonFile& file) const;

private:
    std::string_view text_;
    Json root_;
};

/// The schema as a Markdown page of tables: docs/scene.md.
std::string schemaMarkdown(const Schema& schema);

}  // namespace knuckle
