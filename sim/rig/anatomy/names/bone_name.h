#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace knuckle {

/// What the words of a bone's name mean. Hip, Shoulder, Leg and Arm mean different bones in different programs; the
/// bones around them decide (chain_parts.h).
enum class NamedPart {
    None,
    Hips,
    Hip,
    Spine,
    Neck,
    Head,
    Clavicle,
    Shoulder,
    Arm,
    UpperArm,
    Forearm,
    Hand,
    Finger,
    MaybeFinger,  ///< "middle", "ring": a finger after a hand.
    Leg,
    Coxa,
    Thigh,
    Shin,
    Foot,
    Toe,
    Tail,
    Wing,
    Lever,
};

/// A bone's name, read by itself.
struct BoneName {
    NamedPart part = NamedPart::None;
    int side = 0;             ///< +1 left, -1 right, 0 neither.
    bool isTwist = false;     ///< Takes a share of a limb's turn.
    bool isControl = false;   ///< A handle of the animator's: inverse kinematics, poles, trajectories.
    bool isAttached = false;  ///< Face, hair, clothes, props.
    bool isEnd = false;       ///< Marks the end of a chain.
    /// Its other words, in order, which tell several such limbs apart: "front", "back" and "middle" for all words of
    /// the same meaning, numbers, unknown words.
    std::vector<std::string> others;
};

/// Lower-case words of a name: drops namespaces (`mixamorig:`) and digits, takes camel case and compounds of known
/// words ("lhipjoint", "upperarm") apart, translates Japanese words.
std::vector<std::string> wordsOf(std::string_view name);

BoneName readBoneName(std::string_view name);

}  // namespace knuckle
