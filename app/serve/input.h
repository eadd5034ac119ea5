#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>

namespace knuckle {

/// What a viewer can ask for.
enum class InputKind : uint32_t { Orbit, Pan, Zoom, Home, Pause, Run, Step, Reset, Speed };

/// One wish of a viewer.
struct Input {
    static constexpr std::array<const char*, 9> WORDS{"orbit", "pan",  "zoom",  "home", "pause",
                                                      "run",   "step", "reset", "speed"};

    InputKind kind = InputKind::Pause;
    Eigen::Vector2f by{0, 0};  ///< Orbit: to the right and up [rad]. Pan: of the picture's height.
    float factor = 1.0f;       ///< Zoom: of the distance, 0.1 ... 10. Speed: simulated seconds a second, 0.1 ... 1.
    uint32_t count = 1;        ///< Step: 1 ... 1000.
};

/// Reads {"do": "orbit", "by": [0.1, 0]} and the like. @throws InputError, one line.
Input parseInput(const std::string& text);

}  // namespace knuckle
