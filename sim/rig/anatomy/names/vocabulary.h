#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sim/rig/anatomy/names/bone_name.h"

namespace knuckle {

/// What a word does in a bone's name.
enum class WordUse {
    Part,      ///< Names a part.
    WeakPart,  ///< Names a part if no other word does: "back", "body".
    Left,
    Right,
    Upper,
    Lower,
    Fore,  ///< The lower half of an arm, or a front leg.
    Twist,
    Piece,  ///< A piece of a limb, if another word names one: "HipPart1".
    Control,
    Attached,
    End,
    Filler,  ///< Says nothing, but may be part of a compound: "joint", "base".
};

struct Word {
    WordUse use = WordUse::Filler;
    NamedPart part = NamedPart::None;
};

/// The word, or the one whose plural it is; lower case. None for a word that rigs do not share.
std::optional<Word> findWord(std::string_view word);

/// The name with the Japanese words of MikuMikuDance's bones in English.
std::string translated(std::string_view name);

}  // namespace knuckle
