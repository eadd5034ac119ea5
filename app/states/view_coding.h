#pragma once

#include <string>
#include <vector>

#include "app/states/block_file.h"
#include "sim/solver/measure/view_state.h"
#include "sim/world/world.h"

namespace knuckle {

/// Packs what is drawn of a frame into blocks, and back, bit by bit. Bodies are stored as poses. Particles of a body
/// are stored as how many floats they are away from where its pose has them, which is seldom more than one.
class ViewCoding {
public:
    /// @param world whose states are coded.
    explicit ViewCoding(const World& world);
    /// For states of the world that a file was written for. @param bodies their number.
    /// @throws InputError if the file does not say which particles are whose.
    ViewCoding(const BlockReader& file, size_t bodies);

    /// Blocks that say which particles are whose, for readers without the scene: "bodies/of", "bodies/arms".
    std::vector<std::string> packBodies() const;
    /// Blocks "frame N/...".
    std::vector<std::string> pack(uint64_t frame, const ViewState& view) const;
    /// @throws InputError if the file has no such frame, or one of another world.
    ViewState unpack(const BlockReader& file, uint64_t frame) const;

private:
    void predict(const ViewState& view, std::vector<uint32_t>& x, bool forwards) const;

    size_t particles_ = 0, bodies_ = 0, colliders_ = 0;
    std::vector<uint32_t> owners_;  ///< Body of each particle, or NO_INDEX.
    std::vector<Vector3f> arms_;    ///< Of each particle: from its body's centre at rest [m].
};

/// Parts of frames of what shows them (World::shown).
inline constexpr const char *AGES = "ages", *CONTACT_FORCES = "contactForces";

/// "frame 12/positions".
std::string frameBlock(uint64_t frame, const char* part);

}  // namespace knuckle
