#include "sim/solver/layout/row_plan.h"

namespace knuckle {

uint32_t RowPlan::reserve(uint32_t body, const Vector3f& arm)
{
    reservations_.push_back({body, arm});
    return static_cast<uint32_t>(reservations_.size() - 1);
}

uint32_t RowPlan::reserveAngular(uint32_t body, const Vector3f& arm)
{
    hasAngular_ = true;
    return reserve(body, arm);
}

void RowPlan::place(uint32_t bodyCount)
{
    bodies_.assign(bodyCount, gpu::uvec2{0, 0});
    for (const Reservation& r : reservations_) ++bodies_[r.body].y;
    for (uint32_t b = 1; b < bodyCount; ++b) bodies_[b].x = bodies_[b - 1].x + bodies_[b - 1].y;
    std::vector<uint32_t> taken(bodyCount, 0);
    rows_.clear();
    arms_.resize(reservations_.size());
    for (const Reservation& r : reservations_) {
        rows_.push_back(bodies_[r.body].x + taken[r.body]++);
        arms_[rows_.back()] = r.arm;
    }
}

}  // namespace knuckle
