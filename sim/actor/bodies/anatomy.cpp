#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <vector>

#include "sim/actor/bodies/articulate.h"

namespace knuckle {

namespace {

// "mixamorig:LeftUpLeg" -> left, up, leg; "Bip01 L Calf" -> bip, l, calf; "b_LeftLeg02_016" -> b, left, leg.
std::vector<std::string> tokensOf(std::string_view name)
{
    name.remove_prefix(std::min(name.size(), name.rfind(':') + 1));  // npos + 1 is 0
    std::vector<std::string> tokens(1);
    char previous = ' ';
    for (const char c : name) {
        const bool letter = std::isalpha(static_cast<unsigned char>(c)) != 0;
        const bool upper = std::isupper(static_cast<unsigned char>(c)) != 0;
        if ((!letter || (upper && std::islower(static_cast<unsigned char>(previous)))) && !tokens.back().empty()) {
            tokens.emplace_back();
        }
        if (letter) {
            tokens.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        }
        previous = c;
    }
    return tokens;
}

// Letters alone, sides dropped where they stand apart.
std::string wordsOf(std::string_view name)
{
    std::string words;
    for (const std::string& token : tokensOf(name)) {
        if (token != "l" && token != "r" && token != "left" && token != "right") {
            words += token;
        }
    }
    return words;
}

bool hasAny(const std::string& words, std::initializer_list<const char*> parts)
{
    return std::any_of(parts.begin(), parts.end(),
                       [&](const char* part) { return words.find(part) != std::string::npos; });
}

bool isFinger(const std::string& words)
{
    return hasAny(words, {"finger", "thumb", "index", "middle", "pinky", "little"}) ||
           (hasAny(words, {"ring"}) && !hasAny(words, {"string", "spring"}));
}

}  // namespace

int sideFromName(std::string_view name)
{
    for (const std::string& token : tokensOf(name)) {
        if (token == "l" || token.starts_with("left") || token == "lf") {
            return 1;
        }
        if (token == "r" || token.starts_with("right") || token == "rt") {
            return -1;
        }
    }
    // CMU's "LHipJoint", "rhand": one letter before a word that says what it is.
    const std::string words = tokensOf(name).front().size() > 1 ? tokensOf(name).front() : std::string();
    for (const char* part : {"hip", "hand", "thumb", "fingers", "foot", "shoulder", "arm", "leg", "thigh"}) {
        if (words.size() > 1 && words.substr(1).starts_with(part)) {
            return words[0] == 'l' ? 1 : words[0] == 'r' ? -1 : 0;
        }
    }
    return 0;
}

JointType jointTypeFromName(std::string_view name, std::string_view parentName, std::string_view childName)
{
    const std::string words = wordsOf(name), parent = wordsOf(parentName), child = wordsOf(childName);
    if (hasAny(words, {"twist", "roll"})) {
        return JointType::Stiff;
    }
    if (hasAny(words, {"forearm", "lowerarm", "elbow", "knee", "calf", "shin", "lowerleg", "lowleg", "toe"}) ||
        isFinger(words)) {
        return JointType::Hinge;
    }
    // Mixamo's thigh is UpLeg and its shin Leg; others number two legs.
    if (hasAny(words, {"leg"}) && !hasAny(words, {"up"}) && hasAny(parent, {"leg", "thigh"})) {
        return JointType::Hinge;
    }
    if (hasAny(words, {"clavicle", "collar"})) {
        return JointType::Stiff;
    }
    // A shoulder that carries an arm is a collar bone; one that carries an elbow is the arm itself.
    if (hasAny(words, {"shoulder"}) && hasAny(child, {"arm"}) && !hasAny(child, {"forearm", "lowerarm"})) {
        return JointType::Stiff;
    }
    if (hasAny(words, {"hipjoint", "thigh", "upleg", "upperleg"})) {
        return JointType::Ball;
    }
    const bool trunk = hasAny(words, {"spine", "chest", "torso", "abdomen", "neck", "waist", "pelvis", "ribs"}) ||
                       words == "back" || words == "lowerback" || words == "upperback" || words == "hips" ||
                       words == "body";
    return trunk ? JointType::Stiff : JointType::Ball;
}

}  // namespace knuckle
