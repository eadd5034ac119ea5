#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/rig/actor.h"

namespace knuckle {

/// Turns of an actor's bodies, key after key, as its joints allow them.
class JointTurns {
public:
    explicit JointTurns(const Actor& actor);

    /// Bodies, each after the one that it hangs on.
    const std::vector<uint32_t>& order() const { return order_; }
    /// A body's turn from the rest pose, if there is any; otherwise it goes with its parent.
    using Wanted = std::function<std::optional<Quaternionf>(uint32_t)>;
    /// Adds a key. @param turns gets each body's turn against its parent.
    void addKey(const Wanted& wanted, std::vector<Quaternionf>& turns);
    /// Notes joints that had to leave out much of a clip's turns.
    std::vector<std::string> notes(const std::string& clip) const;

private:
    /// The part of a turn against its parent that a body's joint allows.
    Quaternionf held(uint32_t body, const Quaternionf& relative);
    /// The turn of a universal joint's cross, whose second axis follows the body beyond it.
    Quaternionf crossTurn(uint32_t cross, const Quaternionf& parent, const Wanted& wanted) const;

    const Actor& actor_;
    std::vector<uint32_t> order_;
    std::vector<uint32_t> jointOf_;  ///< Per body, NO_INDEX of the first.
    std::vector<float> leftOut_;     ///< Per body, the most [rad].
    std::vector<Quaternionf> last_;  ///< Per body, of the key before.
};

}  // namespace knuckle
