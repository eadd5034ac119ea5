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

Vector3f leftOf(std::span<const std::string> names, std::span<const Vector3f> places)
{
    Vector3f left = Vector3f::Zero(), right = Vector3f::Zero();
    int lefts = 0, rights = 0;
    for (size_t i = 0; i < names.size(); ++i) {
        const int side = sideFromName(names[i]);
        if (side > 0) left += places[i];
        if (side < 0) right += places[i];
        lefts += side > 0;
        rights += side < 0;
    }
    if (lefts == 0 || rights == 0) return Vector3f::UnitX();
    Vector3f across = left / static_cast<float>(lefts) - right / static_cast<float>(rights);
    across.y() = 0.0f;
    return across.norm() > 1e-4f ? Vector3f(across.normalized()) : Vector3f::UnitX();
}

BodyPart partFromName(std::string_view name, std::string_view parentName, std::string_view childName)
{
    const std::string words = wordsOf(name), parent = wordsOf(parentName), child = wordsOf(childName);
    const bool hasSide = sideFromName(name) != 0;
    if (hasAny(words, {"twist", "roll", "armature", "hipjoint"})) return BodyPart::Other;
    if (hasAny(words, {"toe"})) return BodyPart::Toe;
    if (isFinger(words)) return BodyPart::Finger;
    if (hasAny(words, {"forearm", "lowerarm", "elbow"})) return BodyPart::Forearm;
    if (hasAny(words, {"knee", "calf", "shin", "lowerleg", "lowleg"})) return BodyPart::Shin;
    // Mixamo's thigh is UpLeg and its shin Leg; others number two legs.
    if (hasAny(words, {"leg"}) && !hasAny(words, {"up"}) && hasAny(parent, {"leg", "thigh"})) return BodyPart::Shin;
    if (hasAny(words, {"clavicle", "collar"})) return BodyPart::Clavicle;
    // A shoulder that carries an arm is a collar bone; one that carries an elbow is the arm itself.
    if (hasAny(words, {"shoulder"}))
        return hasAny(child, {"arm"}) && !hasAny(child, {"forearm", "lowerarm"}) ? BodyPart::Clavicle
                                                                                 : BodyPart::UpperArm;
    if (hasAny(words, {"thigh", "leg"}) || (hasSide && words == "hip")) return BodyPart::Thigh;
    if (hasAny(words, {"arm"})) return BodyPart::UpperArm;
    if (hasAny(words, {"hand", "wrist"})) return BodyPart::Hand;
    if (hasAny(words, {"foot", "ankle"})) return BodyPart::Foot;
    if (hasAny(words, {"neck"})) return BodyPart::Neck;
    if (hasAny(words, {"head"})) return BodyPart::Head;
    if (hasAny(words, {"pelvis"}) || words == "hips" || words == "hip") return BodyPart::Hips;
    const bool spine = hasAny(words, {"spine", "chest", "torso", "abdomen", "waist", "ribs"}) || words == "back" ||
                       words == "lowerback" || words == "upperback" || words == "body";
    return spine ? BodyPart::Spine : BodyPart::Other;
}

JointType jointTypeFromName(std::string_view name, std::string_view parentName, std::string_view childName)
{
    if (hasAny(wordsOf(name), {"twist", "roll"})) return JointType::Stiff;
    switch (partFromName(name, parentName, childName)) {
        case BodyPart::Forearm:
        case BodyPart::Shin:
        case BodyPart::Toe:
        case BodyPart::Finger: return JointType::Hinge;
        case BodyPart::Clavicle:
        case BodyPart::Spine:
        case BodyPart::Neck:
        case BodyPart::Hips: return JointType::Stiff;
        default: return JointType::Ball;
    }
}

}  // namespace knuckle
