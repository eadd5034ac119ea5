#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/actor/actor.h"

namespace knuckle {

/// Turns of an actor's bodies, key after key, as its joints let them be.
class JointTurns {
public:
    explicit JointTurns(const Actor& actor);

    /// Bodies, each behind what it hangs on.
    const std::vector<uint32_t>& order() const { return order_; }
    /// Adds a key. @param wanted how a body is turned from the rest pose. @param known whether anybody says so; else it
    /// goes with its parent. @param turns gets each body's turn against its parent.
    void addKey(const std::function<Quaternionf(uint32_t)>& wanted, const std::function<bool(uint32_t)>& known,
                std::vector<Quaternionf>& turns);
    /// Which joints had to leave out much of what the clip says.
    std::vector<std::string> notes(const std::string& clip) const;

private:
    Quaternionf held(uint32_t body, const Quaternionf& relative);

    const Actor& actor_;
    std::vector<uint32_t> order_;
    std::vector<uint32_t> jointOf_;  ///< Per body, NO_INDEX of the first.
    std::vector<float> leftOut_;     ///< Per body, the most [rad].
    std::vector<Quaternionf> last_;  ///< Per body, of the key before.
};

}  // namespace knuckle
