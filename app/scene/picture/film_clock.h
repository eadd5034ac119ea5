#pragma once

#include <cstdint>
#include <vector>

#include "render/settings.h"

namespace knuckle {

/// The steps that have been taken when a frame is drawn, and where between the last two it lies.
struct FramePlace {
    uint64_t steps = 0;
    double part = 1.0;  ///< Above 0, up to 1: after the last step.
};

/// Which state each frame of a film shows. The simulation always takes the same steps; slow and fast motion take them
/// at another pace, and stand between them where a frame does.
class FilmClock {
public:
    FilmClock() = default;
    /// @param stepsPerFrame at full speed. @param shots in order; empty: full speed throughout.
    FilmClock(double framesPerSecond, uint32_t stepsPerFrame, const std::vector<Shot>& shots);

    /// @param frame from 1 on.
    FramePlace at(uint64_t frame) const;
    /// Whether frame N shows the state after (N - 1) times as many steps, for all N.
    bool isEven() const { return even_; }
    /// Whether both show the same states at every frame.
    bool operator==(const FilmClock& other) const = default;

private:
    /// From a frame on, a pace.
    struct Pace {
        uint64_t frame = 1;
        double steps = 0.0;     ///< Taken at that frame.
        double perFrame = 1.0;  ///< From there on.
        bool operator==(const Pace&) const = default;
    };
    std::vector<Pace> paces_{Pace{}};
    bool even_ = true;
};

}  // namespace knuckle
