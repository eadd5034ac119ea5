#pragma once

#include <map>
#include <string>
#include <vector>

#include "shared/gpu_types.h"
#include "sim/world/world.h"

namespace knuckle {

/// Assigns rows of the channel, through which constraints act on bodies: each kind of constraint reserves rows, one for
/// each impulse on a body, and writes them in every iteration; mover_solve sums the rows of a body without knowing
/// kinds. Made from the World alone.
class RowPlan {
public:
    /// A row for an impulse at `arm` from the body's centre, in its axes [m]. @param kind of the constraint.
    void reserve(const std::string& kind, uint32_t body, const Vector3f& arm);
    /// The same for a row with an angular impulse as well, or only that.
    void reserveAngular(const std::string& kind, uint32_t body, const Vector3f& arm = {0, 0, 0});
    /// Places all reserved rows: the rows of a body together, in the order of their reservation.
    void place(uint32_t bodyCount);

    /// The rows of a kind in the order of their reservation, after place(); empty if it reserved none.
    std::vector<uint32_t> rowsOf(const std::string& kind) const;
    const std::vector<gpu::uvec2>& bodies() const { return bodies_; }  ///< Per body: its first row, and how many.
    const std::vector<Vector3f>& arms() const { return arms_; }        ///< Per row, once they have places [m].
    bool hasAngular() const { return hasAngular_; }

private:
    struct Reservation {
        uint32_t body = 0;
        Vector3f arm{0, 0, 0};
    };

    std::vector<Reservation> reservations_;
    std::map<std::string, std::vector<size_t>> kinds_;  ///< Indices of reservations.
    std::vector<uint32_t> rows_;                        ///< Per reservation.
    std::vector<gpu::uvec2> bodies_;
    std::vector<Vector3f> arms_;
    bool hasAngular_ = false;
};

}  // namespace knuckle
