#include "sim/rig/import/assimp/nodes/figure_nodes.h"

#include <algorithm>
#include <set>
#include <utility>

#include "sim/rig/anatomy/names/bone_name.h"

namespace knuckle {

namespace {

using enum NamedPart;

constexpr size_t FEWEST_PAIRS = 2;  // parts of limbs that exist on both sides

bool isUpper(NamedPart part)
{
    return part == Arm || part == UpperArm || part == Shoulder || part == Leg || part == Thigh || part == Hip;
}

bool isLower(NamedPart part)
{
    return part == Forearm || part == Hand || part == Shin || part == Foot;
}

/// Parts of a body that the names of a scene's nodes mean.
class NamedNodes {
public:
    explicit NamedNodes(const NodeTable& table) : table_(table)
    {
        for (uint32_t n = 0; n < table.nodes.size(); ++n) names_.push_back(readBoneName(table.nameOf(n)));
    }

    /// The node of a part of a body that moves a mesh: if a bone and its mesh are both named after the part, the bone.
    /// NO_INDEX: none.
    uint32_t boneOf(uint32_t mesh) const
    {
        auto n = static_cast<int32_t>(mesh);
        while (n >= 0 && names_[static_cast<size_t>(n)].part == None) n = table_.parents[static_cast<size_t>(n)];
        if (n < 0) return NO_INDEX;
        const int32_t parent = table_.parents[static_cast<size_t>(n)];
        const bool isMesh = static_cast<uint32_t>(n) == mesh && parent >= 0 && table_.nodes[parent]->mNumMeshes == 0;
        return static_cast<uint32_t>(isMesh && isAlike(parent, n) ? parent : n);
    }

    /// Whether such bones form a figure: limbs on both sides, with a head or hips or with lower halves that hang on
    /// upper ones.
    bool isFigure(const std::set<uint32_t>& bones) const
    {
        std::set<std::pair<NamedPart, int>> parts;
        bool trunk = false, chain = false;
        for (const uint32_t b : bones) {
            const BoneName& name = names_[b];
            trunk = trunk || name.part == Head || name.part == Neck || name.part == Hips;
            if (name.side != 0 && (isUpper(name.part) || isLower(name.part))) parts.emplace(name.part, name.side);
            chain = chain || (isLower(name.part) && hangsOnUpper(b));
        }
        const auto pairs = std::ranges::count_if(parts, [&](const auto& part) {
            return part.second > 0 && parts.contains({part.first, -1});
        });
        return (trunk || chain) && static_cast<size_t>(pairs) >= FEWEST_PAIRS;
    }

private:
    bool isAlike(int32_t a, int32_t b) const
    {
        const BoneName &name = names_[static_cast<size_t>(a)], &other = names_[static_cast<size_t>(b)];
        return name.part == other.part && name.side == other.side;
    }

    bool hangsOnUpper(uint32_t bone) const
    {
        const int side = names_[bone].side;
        for (int32_t n = table_.parents[bone]; n >= 0; n = table_.parents[static_cast<size_t>(n)])
            if (const BoneName& name = names_[static_cast<size_t>(n)]; isUpper(name.part) && name.side == side)
                return true;
        return false;
    }

    const NodeTable& table_;
    std::vector<BoneName> names_;
};

}  // namespace

std::vector<uint32_t> figureNodes(const NodeTable& table)
{
    const NamedNodes named(table);
    std::set<uint32_t> bones;
    uint32_t common = NO_INDEX;
    bool isAnyOther = false;
    for (uint32_t n = 0; n < table.nodes.size(); ++n) {
        if (table.nodes[n]->mNumMeshes == 0) continue;
        common = common == NO_INDEX ? n : table.commonNode(common, n);
        const uint32_t bone = named.boneOf(n);
        if (bone == NO_INDEX) isAnyOther = true;
        else bones.insert(bone);
    }
    if (!named.isFigure(bones)) return {};
    if (isAnyOther) bones.insert(common);
    return {bones.begin(), bones.end()};
}

}  // namespace knuckle
