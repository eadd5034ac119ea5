#include "sim/solver/layout/row_plan.h"

namespace knuckle {

void RowPlan::reserve(const std::string& kind, uint32_t body, const Vector3f& arm)
{
    kinds_[kind].push_back(reservations_.size());
    reservations_.push_back({body, arm});
}

void RowPlan::reserveAngular(const std::string& kind, uint32_t body, const Vector3f& arm)
{
    hasAngular_ = true;
    reserve(kind, body, arm);
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

std::vector<uint32_t> RowPlan::rowsOf(const std::string& kind) const
{
    std::vector<uint32_t> rows;
    if (const auto found = kinds_.find(kind); found != kinds_.end())
        for (const size_t reservation : found->second) rows.push_back(rows_[reservation]);
    return rows;
}

}  // namespace knuckle
