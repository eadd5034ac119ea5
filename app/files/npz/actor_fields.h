#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace knuckle {

/// What the values of an array of an actor are.
enum class ActorValue { Float, Double, Integer, Flag, Word };

/// An array of an actor's file.
struct ActorField {
    const char* name;  ///< Of its group, "" for none, with `_`, and the field in the document.
    ActorValue value;
    std::vector<size_t> shape;  ///< Of an entry; ANY: of any length, which only the first can be.
    const char* group = "";     ///< "bodies", "joints": an entry for each.

    bool isList() const;          ///< Whether each entry of a group has a list, so that there is a second array.
    std::string list() const;     ///< "bodies_particles_starts"
    std::string pointer() const;  ///< Within the document, or an entry of the group: "/limits/bend".
};

constexpr size_t ANY = SIZE_MAX;

/// All, in the order of the file.
const std::vector<ActorField>& actorFields();

}  // namespace knuckle
