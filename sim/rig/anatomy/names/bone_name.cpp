#include "sim/rig/anatomy/names/bone_name.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <optional>

#include "sim/rig/anatomy/names/vocabulary.h"

namespace knuckle {

namespace {

bool isUpper(char c)
{
    return std::isupper(static_cast<unsigned char>(c)) != 0;
}

bool isLetter(char c)
{
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// "LHipJoint" -> l, hip, joint; "Bip01 L Calf" -> bip, l, calf; "IKFoot" -> ik, foot.
std::vector<std::string> tokensOf(std::string_view name)
{
    std::vector<std::string> tokens(1);
    for (size_t i = 0; i < name.size(); ++i) {
        const char c = name[i], before = i > 0 ? name[i - 1] : ' ', after = i + 1 < name.size() ? name[i + 1] : ' ';
        const bool lowerAfter = isLetter(after) && !isUpper(after);
        const bool startsWord = isUpper(c) && isLetter(before) && (!isUpper(before) || lowerAfter);
        if ((startsWord || !isLetter(c)) && !tokens.back().empty()) tokens.emplace_back();
        if (isLetter(c)) tokens.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    if (tokens.back().empty()) tokens.pop_back();
    return tokens;
}

/// Whether the text consists of known words, which are added, the longest first.
bool splitCompound(std::string_view text, std::vector<std::string>& words)
{
    if (text.empty()) return true;
    for (size_t length = text.size(); length >= 2; --length) {
        const std::string_view first = text.substr(0, length);
        const std::optional<Word> word = findWord(first);
        const bool joins = word && word->use != WordUse::End && (length >= 3 || first == "up" || first == "lo");
        if (!joins) continue;
        words.emplace_back(first);
        if (splitCompound(text.substr(length), words)) return true;
        words.pop_back();
    }
    return false;
}

bool namesPart(const std::vector<std::string>& words)
{
    return std::ranges::any_of(words, [](const std::string& word) { return findWord(word)->use == WordUse::Part; });
}

void addWords(const std::string& token, std::vector<std::string>& words)
{
    std::vector<std::string> found;
    if (findWord(token) || !splitCompound(token, found)) {
        found.clear();
        const bool sided = token[0] == 'l' || token[0] == 'r';
        if (!findWord(token) && sided && splitCompound(std::string_view(token).substr(1), found) && namesPart(found))
            found.insert(found.begin(), token.substr(0, 1));
        else found = {token};
    }
    words.insert(words.end(), found.begin(), found.end());
}

/// An arm or a leg, with a word for one of its halves; a torso's lower half is the hips.
NamedPart halved(NamedPart part, bool upper, bool lower, bool fore)
{
    switch (part) {
        case NamedPart::Arm: return lower || fore ? NamedPart::Forearm : upper ? NamedPart::UpperArm : part;
        case NamedPart::Leg: return lower ? NamedPart::Shin : upper ? NamedPart::Thigh : part;
        case NamedPart::None: return fore ? NamedPart::MaybeFinger : part;
        default: return part;
    }
}

/// A corner of a body on four legs.
struct Corner {
    std::string_view word;
    const char* place;
    int side;
};
constexpr Corner CORNERS[] = {{"fl", "front", 1}, {"fr", "front", -1}, {"lf", "front", 1}, {"rf", "front", -1},
                              {"bl", "back", 1},  {"br", "back", -1},  {"lb", "back", 1},  {"rb", "back", -1},
                              {"hl", "back", 1},  {"hr", "back", -1},  {"rl", "back", 1},  {"rr", "back", -1}};

const Corner* cornerOf(const std::string& text)
{
    const auto* const corner = std::ranges::find(CORNERS, std::string_view(text), &Corner::word);
    return corner == std::end(CORNERS) ? nullptr : corner;
}

/// The place among several limbs that a word names; empty if it names none.
std::string placeWord(const std::string& text)
{
    if (const Corner* corner = cornerOf(text)) return corner->place;
    if (text == "front" || text == "fore") return "front";
    if (text == "back" || text == "hind" || text == "rear") return "back";
    if (text == "middle" || text == "mid") return "middle";
    return findWord(text) ? "" : text;
}

/// Numbers without leading zeros.
std::vector<std::string> numbersIn(std::string_view name)
{
    std::vector<std::string> numbers;
    bool inNumber = false;
    for (const char c : name) {
        const bool isDigit = c >= '0' && c <= '9';
        if (isDigit && !inNumber) numbers.emplace_back();
        inNumber = isDigit;
        if (isDigit && !(numbers.back().empty() && c == '0')) numbers.back() += c;
    }
    return numbers;
}

}  // namespace

std::vector<std::string> wordsOf(std::string_view name)
{
    name.remove_prefix(std::min(name.size(), name.find_last_of(":|") + 1));  // npos + 1 is 0
    std::vector<std::string> words;
    for (const std::string& token : tokensOf(translated(name))) addWords(token, words);
    return words;
}

BoneName readBoneName(std::string_view name)
{
    BoneName read;
    NamedPart weak = NamedPart::None, muscle = NamedPart::None;
    bool upper = false, lower = false, fore = false, trunk = false, foot = false, piece = false, unknown = false,
         corner = false;
    for (const std::string& text : wordsOf(name)) {
        const std::optional<Word> found = findWord(text);
        const Word word = found.value_or(Word{});
        unknown |= !found && text.size() > 1;
        switch (word.use) {
            case WordUse::Left: read.side = read.side == 0 ? 1 : read.side; break;
            case WordUse::Right: read.side = read.side == 0 ? -1 : read.side; break;
            case WordUse::Upper: upper = true; break;
            case WordUse::Lower: lower = true; break;
            case WordUse::Fore: fore = true; break;
            case WordUse::Twist: read.isTwist = true; break;
            case WordUse::Piece: piece = true; break;
            case WordUse::Control: read.isControl = true; break;
            case WordUse::Attached:
                read.isAttached = true;
                muscle = word.part == NamedPart::None ? muscle : word.part;
                break;
            case WordUse::End: read.isEnd = true; break;
            case WordUse::Part:
                foot |= word.part == NamedPart::Foot || word.part == NamedPart::Toe;
                read.part = word.part;
                break;
            case WordUse::WeakPart: weak = word.part; break;
            case WordUse::Filler: break;
        }
        if (const Corner* at = cornerOf(text)) {
            corner = true;
            read.side = read.side == 0 ? at->side : read.side;
        }
        trunk |= text == "torso" || text == "body";
        if (std::string place = placeWord(text); !place.empty()) read.others.push_back(std::move(place));
    }
    for (std::string& number : numbersIn(name)) read.others.push_back(std::move(number));
    std::ranges::sort(read.others);
    // "LeftHandIndex1": after a hand's word, a finger's counts.
    if (weak == NamedPart::MaybeFinger && read.part == NamedPart::Hand) read.part = NamedPart::Finger;
    // "back_trochantin.L": for a limb, back is a place.
    if (weak == NamedPart::Spine && unknown && read.side != 0) weak = NamedPart::None;
    if (read.part == NamedPart::None) read.part = weak != NamedPart::None ? weak : muscle;
    // "FL_upper"
    if (corner && (upper || lower) && read.part == NamedPart::None) read.part = NamedPart::Leg;
    if (foot && read.part == NamedPart::Finger) read.part = NamedPart::Toe;
    read.part = halved(read.part, upper, lower, fore);
    if (read.part == NamedPart::Spine && trunk && lower) read.part = NamedPart::Hips;
    read.isTwist |= piece && read.part != NamedPart::None;
    return read;
}

}  // namespace knuckle
