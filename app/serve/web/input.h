#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace knuckle {

/// What a viewer can ask for.
enum class InputKind : uint32_t {
    Orbit,
    Pan,
    Zoom,
    Home,
    Pause,
    Run,
    Step,
    Reset,
    Speed,
    Share,
    Pick,
    Grab,
    Drag,
    Drop,
    Throw,
    Ball,
    Push,
    Release,
    Set,
    Restart
};

/// One wish of a viewer.
struct Input {
    static constexpr std::array<const char*, 20> WORDS{"orbit", "pan",   "zoom",  "home",    "pause", "run",    "step",
                                                       "reset", "speed", "share", "pick",    "grab",  "drag",   "drop",
                                                       "throw", "ball",  "push",  "release", "set",   "restart"};

    InputKind kind = InputKind::Pause;
    Eigen::Vector2f by{0, 0};  ///< Orbit: to the right and up [rad]. Pan: of the picture's height.
    /// Zoom: of the distance, 0.1 ... 10. Speed: simulated seconds a second, 0.1 ... 1. Share: of the time, for
    /// pictures, 0.01 ... 1. Throw, Ball: the speed that it gets, away from the camera [m/s], 0.1 ... 50.
    float factor = 1.0f;
    uint32_t count = 1;        ///< Step: 1 ... 1000.
    Eigen::Vector2f at{0, 0};  ///< Pick, Grab, Drag, Throw, Ball: from the upper left corner, in shares of the picture.
    std::string name = {};     ///< Push, Release: of a body; Release: of an object, too; Set: of a field.
    std::vector<float> value = {};                           ///< Set: one number, or three.
    std::vector<std::string> sets = {};                      ///< Restart: changes of the scene, as "solver.substeps=8".
    Eigen::Vector3f impulse{0, 0, 0};                        ///< Push [N s].
    std::optional<Eigen::Vector3f> place = {};               ///< Push: where [m]; none: at the mass centre.
    std::shared_ptr<std::promise<std::string>> answer = {};  ///< Of those that want one: gets JSON.

    /// Whether it names a place of the picture.
    bool points() const { return kind == InputKind::Drag || kind == InputKind::Ball || finds(); }
    bool wantsAnswer() const
    {
        return finds() || kind == InputKind::Ball || kind == InputKind::Set || kind == InputKind::Restart;
    }

private:
    bool finds() const { return kind == InputKind::Pick || kind == InputKind::Grab || kind == InputKind::Throw; }
};

/// Reads {"do": "orbit", "by": [0.1, 0]} and the like. @throws InputError, one line.
Input parseInput(const std::string& text);

}  // namespace knuckle
