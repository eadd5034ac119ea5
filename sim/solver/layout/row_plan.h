#pragma once

#include <vector>

#include "shared/gpu_types.h"
#include "sim/world/world.h"

namespace knuckle {

/// Which rows of the channel belong to whom. Through it constraints act on bodies: each kind reserves rows, one for
/// each impulse on a body, and writes them in every iteration; mover_solve sums the rows of a body without knowing
/// kinds.
class RowPlan {
public:
    /// A row for an impulse at `arm` from the body's centre, in its axes [m]. @returns what rowOf() takes.
    uint32_t reserve(uint32_t body, const Vector3f& arm);
    /// The same for one with an angular impulse, too.
    uint32_t reserveAngular(uint32_t body, const Vector3f& arm);
    /// Gives all that is reserved its place: the rows of a body together, in the order of their reservation.
    void place(uint32_t bodyCount);

    uint32_t rowOf(uint32_t reservation) const { return rows_[reservation]; }
    const std::vector<gpu::uvec2>& bodies() const { return bodies_; }  ///< Per body: its first row, and how many.
    const std::vector<Vector3f>& arms() const { return arms_; }        ///< Per row, once they have places [m].
    bool hasAngular() const { return hasAngular_; }

private:
    struct Reservation {
        uint32_t body = 0;
        Vector3f arm{0, 0, 0};
    };

    std::vector<Reservation> reservations_;
    std::vector<uint32_t> rows_;
    std::vector<gpu::uvec2> bodies_;
    std::vector<Vector3f> arms_;
    bool hasAngular_ = false;
};

}  // namespace knuckle
