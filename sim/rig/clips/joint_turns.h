#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/rig/actor.h"

namespace knuckle {

/// Turns of an actor's bodies, key after key, as its joints let them be.
class JointTurns {
public:
    explicit JointTurns(const Actor& actor);

    /// Bodies, each behind what it hangs on.
    const std::vector<uint32_t>& order() const { return order_; }
    /// How a body is turned from the rest pose, where anybody says so; else it goes with its parent.
    using Wanted = std::function<std::optional<Quaternionf>(uint32_t)>;
    /// Adds a key. @param turns gets each body's turn against its parent.
    void addKey(const Wanted& wanted, std::vector<Quaternionf>& turns);
    /// Which joints had to leave out much of what the clip says.
    std::vector<std::string> notes(const std::string& clip) const;

private:
    /// What of a turn against its parent a body's joint lets be.
    Quaternionf held(uint32_t body, const Quaternionf& relative);
    /// Of a universal joint's cross, whose second axis goes where the body behind it has it.
    Quaternionf crossTurn(uint32_t cross, const Quaternionf& parent, const Wanted& wanted) const;

    const Actor& actor_;
    std::vector<uint32_t> order_;
    std::vector<uint32_t> jointOf_;  ///< Per body, NO_INDEX of the first.
    std::vector<float> leftOut_;     ///< Per body, the most [rad].
    std::vector<Quaternionf> last_;  ///< Per body, of the key before.
};

}  // namespace knuckle
