#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

enum class CameraKind : uint32_t { Fixed, Orbit, Follow };

/// How a camera passes from a key to the next one.
enum class Easing : uint32_t {
    Smooth,     ///< On a curve through all keys, without a jolt, and never beyond two neighbours.
    Linear,     ///< At one speed.
    EaseIn,     ///< Begins slowly.
    EaseOut,    ///< Ends slowly.
    EaseInOut,  ///< Both.
    Hold        ///< Stays, and jumps at the next key.
};

/// Where a camera is at a time, and how it goes on from there.
struct CameraKey {
    double time = 0.0;                           ///< Of the film [s].
    Eigen::Vector3f position{4.0f, 2.5f, 6.0f};  ///< [m]
    Eigen::Vector3f target{0.0f, 1.0f, 0.0f};    ///< [m]
    float fieldOfView = 40.0f;                   ///< Vertical [degrees], 5 ... 120.
    float roll = 0.0f;                           ///< [degrees], as CameraSettings::roll.
    float aperture = 0.0f, focus = 0.0f;         ///< [m], as CameraSettings'.
    Easing easing = Easing::Smooth;
};

/// A hand that holds the camera.
struct CameraShake {
    float amplitude = 0.0f;  ///< It never turns further than this, either way [degrees], 0 ... 20.
    float frequency = 1.0f;  ///< [Hz], 0.01 ... 20.
    uint32_t seed = 1;       ///< Another one shakes otherwise.
};

/// What of the named particles a camera does.
enum class CameraAttention : uint32_t {
    None,   ///< Goes by all particles.
    Frame,  ///< Keeps them whole in the picture.
    LookAt  ///< Turns to their middle.
};

struct CameraSettings {
    CameraKind kind = CameraKind::Fixed;
    bool automatic = true;                       ///< Chooses position and target in each frame so that everything is
                                                 ///< visible.
    Eigen::Vector3f position{4.0f, 2.5f, 6.0f};  ///< [m]; Follow: from the object's middle.
    Eigen::Vector3f target{0.0f, 1.0f, 0.0f};    ///< [m]; Orbit: the centre. Follow: from the object's middle.
    float fieldOfView = 40.0f;                   ///< Vertical [degrees], 5 ... 120.
    float roll = 0.0f;                           ///< Counter-clockwise turn of the camera [degrees], -360 ... 360.
    float orbitSpeed = 15.0f;                    ///< Orbit only [degrees/s], about +Y.
    std::string follow;                          ///< Follow only: name of the object whose middle it follows.
    float fill = 0.85f;  ///< Share of the picture that framed things fill, in one direction or both, 0.2 ... 1.
    std::vector<CameraKey> keys = {};  ///< Fixed only; in order of time. They stand above position, target, ...
    CameraShake shake = {};
    CameraAttention attention = CameraAttention::None;
    float aperture = 0.0f;                    ///< Diameter of the lens [m], 0 ... 100; 0: everything is sharp.
    float focus = 0.0f;                       ///< Distance along its axis of what is sharp [m]; 0: what it looks at.
    std::vector<ParticleRange> focused = {};  ///< Whose middle is sharp instead; empty: nobody's.
    std::vector<ParticleRange> named = {};    ///< Whom attention is for; not empty unless it is None.
};

/// What a frame shows beside what its camera sees.
enum class PictureLayout : uint32_t {
    One,     ///< Nothing.
    Inset,   ///< What another camera sees, small, in a corner.
    Beside,  ///< The same in its right half.
};

enum class Corner : uint32_t { TopLeft, TopRight, BottomLeft, BottomRight };

/// A part of a film: one camera or two, one pace.
struct Shot {
    double from = 0.0;       ///< Of the film [s]; the first begins at 0.
    float timeScale = 1.0f;  ///< Simulated seconds a second of film, 0 ... 1000; 0: it stands still.
    CameraSettings camera = {};
    PictureLayout layout = PictureLayout::One;
    CameraSettings other = {};             ///< The second camera, if there is one.
    Corner insetAt = Corner::BottomRight;  ///< Inset only.
};

/// The shot at a time of the film [s]: the last that has begun. @param shots in order, not empty.
size_t shotAt(const std::vector<Shot>& shots, double time);

}  // namespace knuckle
