#include "sim/rig/anatomy/names/vocabulary.h"

#include <map>

namespace knuckle {

namespace {

using Entry = std::pair<std::string_view, std::string_view>;

constexpr Entry JAPANESE[] = {
    {"足首", " ankle "},
    {"足先", " toe "},
    {"つま先", " toe "},
    {"爪先", " toe "},
    {"手首", " wrist "},
    {"太もも", " thigh "},
    {"太腿", " thigh "},
    {"もも", " thigh "},
    {"大腿", " thigh "},
    {"すね", " shin "},
    {"脛", " shin "},
    {"背骨", " spine "},
    {"乳首", " breast "},
    {"手捩", " forearm twist "},
    {"手捻", " forearm twist "},
    {"親指", " thumb "},
    {"人指", " index finger "},
    {"人差指", " index finger "},
    {"人差し指", " index finger "},
    {"中指", " middle finger "},
    {"薬指", " ring finger "},
    {"小指", " little finger "},
    {"上半身", " spine "},
    {"下半身", " hips "},
    {"全ての親", " master "},
    {"センター", " center "},
    {"グルーブ", " groove "},
    {"キャンセル", " cancel "},
    {"ダミー", " dummy "},
    {"スカート", " skirt "},
    {"ネクタイ", " tie "},
    {"ひざ", " knee "},
    {"ヒザ", " knee "},
    {"膝", " knee "},
    {"ひじ", " elbow "},
    {"ヒジ", " elbow "},
    {"肘", " elbow "},
    {"ＩＫ", " ik "},
    {"左", " left "},
    {"右", " right "},
    {"捩", " twist "},
    {"捻", " twist "},
    {"肩", " shoulder "},
    {"腕", " arm "},
    {"手", " hand "},
    {"足", " leg "},
    {"首", " neck "},
    {"頭", " head "},
    {"腰", " waist "},
    {"目", " eye "},
    {"髪", " hair "},
    {"胸", " breast "},
    {"舌", " tongue "},
    {"歯", " tooth "},
    {"親", " parent "},
    {"先", " end "},
};

struct Words {
    WordUse use;
    NamedPart part;
    std::string_view list;  ///< Separated by spaces.
};

constexpr Words WORDS[] = {
    {WordUse::Left, NamedPart::None, "left l lt lf lft lh fl bl hl rl le sx izq izquierda izquierdo gauche links"},
    {WordUse::Right, NamedPart::None, "right r rt rf rgt rh fr br hr rr ri dx der derecha derecho droite rechts"},
    {WordUse::Upper, NamedPart::None, "upper up"},
    {WordUse::Lower, NamedPart::None, "lower low lo"},
    {WordUse::Fore, NamedPart::None, "fore"},
    {WordUse::Twist, NamedPart::None, "twist roll twst share helper"},
    {WordUse::Piece, NamedPart::None, "part"},
    {WordUse::End, NamedPart::None, "end nub site effector"},
    {WordUse::Filler, NamedPart::None, "base bone joint jnt bend def skin big small front hind rear"},
    {WordUse::Control, NamedPart::None,
     "ik fk ctrl control controller ctl pole target goal mch org trajectory master mother reference null locator "
     "socket dummy parent groove center centre cog tweak widget cancel armature vb origin pivot aim root"},
    {WordUse::Attached, NamedPart::None,
     "hair bang fringe braid ponytail pigtail ahoge eye eyelid eyebrow eyelash brow lid lash jaw lip tongue tooth "
     "teeth gum cheek nose nostril ear earring face facial mouth chin forehead temple glasses horn antler mane beak "
     "whisker feather fur"},
    {WordUse::Attached, NamedPart::None,
     "weapon sword gun rifle pistol bow arrow quiver staff prop shield item attach attachment helmet hat cap crown "
     "mask hood skirt cape cloak dress coat jacket robe cloth sleeve scarf tie ribbon necklace pendant belt "
     "buckle bag backpack pouch holster sheath strap string armor armour plate pad guard band headband wristband "
     "watch sec tops camera light scabbard apron poncho neckerchief handle mantel mantle"},
    {WordUse::Attached, NamedPart::None,
     "breast boob bust pectoral pec butt buttock glute belly stomach muscle tricep trapezius lat deltoid corrective "
     "heel adj"},
    // Muscles, which some use as names of the limb itself.
    {WordUse::Attached, NamedPart::UpperArm, "bicep"},
    {WordUse::Attached, NamedPart::Thigh, "quad quadricep"},
    {WordUse::Part, NamedPart::Hips, "hips pelvis pelvic"},
    {WordUse::Part, NamedPart::Hip, "hip"},
    {WordUse::WeakPart, NamedPart::Spine, "back body trunk"},
    {WordUse::Part, NamedPart::Spine,
     "spine spinal chest torso abdomen abdominal waist rib ribs ribcage thorax lumbar"},
    {WordUse::Part, NamedPart::Neck, "neck"},
    {WordUse::Part, NamedPart::Head, "head skull"},
    {WordUse::Part, NamedPart::Clavicle, "clavicle clav clavical collar scapula collarbone"},
    {WordUse::Part, NamedPart::Shoulder, "shoulder"},
    {WordUse::Part, NamedPart::Arm, "arm"},
    {WordUse::Part, NamedPart::UpperArm, "humerus shldr"},
    {WordUse::Part, NamedPart::Forearm, "forearm elbow radius ulna"},
    {WordUse::Part, NamedPart::Hand, "hand wrist palm carpal metacarpal"},
    {WordUse::Part, NamedPart::Finger, "finger thumb pinky pinkie"},
    {WordUse::WeakPart, NamedPart::MaybeFinger, "index middle mid ring little third"},
    {WordUse::Part, NamedPart::Leg, "leg limb"},
    {WordUse::Part, NamedPart::Coxa, "coxa trochanter"},
    {WordUse::Part, NamedPart::Thigh, "thigh femur"},
    {WordUse::Part, NamedPart::Shin, "shin calf tibia fibula knee crus patella stifle"},
    {WordUse::Part, NamedPart::Foot,
     "foot feet ankle metatarsal metatarsus tarsal tarsus paw hoof hooves hock cannon fetlock "
     "pastern trotter talon"},
    {WordUse::Part, NamedPart::Toe, "toe ball"},
    {WordUse::Part, NamedPart::Tail, "tail"},
    {WordUse::Part, NamedPart::Wing, "wing fin flipper"},
    {WordUse::Part, NamedPart::Lever, "boom jib dipper bucket lever"},
};

std::map<std::string_view, Word> makeVocabulary()
{
    std::map<std::string_view, Word> vocabulary;
    for (const Words& words : WORDS) {
        for (std::string_view rest = words.list; !rest.empty();) {
            const size_t end = std::min(rest.find(' '), rest.size());
            vocabulary[rest.substr(0, end)] = {words.use, words.part};
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    }
    return vocabulary;
}

}  // namespace

std::optional<Word> findWord(std::string_view word)
{
    static const std::map<std::string_view, Word> vocabulary = makeVocabulary();
    if (const auto found = vocabulary.find(word); found != vocabulary.end()) return found->second;
    if (word.size() < 4 || !word.ends_with('s')) return {};
    const auto singular = vocabulary.find(word.substr(0, word.size() - 1));
    return singular == vocabulary.end() ? std::nullopt : std::optional(singular->second);
}

std::string translated(std::string_view name)
{
    std::string english;
    while (!name.empty()) {
        const Entry* found = nullptr;
        for (const Entry& entry : JAPANESE)
            if (name.starts_with(entry.first) && (!found || entry.first.size() > found->first.size())) found = &entry;
        english += found ? found->second : name.substr(0, 1);
        name.remove_prefix(found ? found->first.size() : 1);
    }
    return english;
}

}  // namespace knuckle
