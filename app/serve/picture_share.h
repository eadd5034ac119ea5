#pragma once

#include <algorithm>

namespace knuckle {

/// The part of the time in which a picture may be in the making: as much as goes while steps keep up with time, and a
/// small part where they do not.
class PictureShare {
public:
    /// @param least that pictures get from a simulation that is behind, 0.01 ... 1.
    explicit PictureShare(double least) { setLeast(least); }

    void setLeast(double least) { share_ = least_ = least; }
    double least() const { return least_; }
    /// After steps. @param behind whether they are late.
    void note(bool behind) { share_ = std::clamp(share_ * (behind ? LESS : MORE), least_, 1.0); }
    double now() const { return share_; }

private:
    static constexpr double LESS = 0.8, MORE = 1.02;

    double least_ = 1.0, share_ = 1.0;
};

}  // namespace knuckle
