#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "render/camera_settings.h"

namespace knuckle {

struct LightSettings {
    Eigen::Vector3f direction{-0.5f, 0.85f, 0.45f};  ///< Towards the key light; normalized when used.
    float intensity = 3.0f;                          ///< Key light, 0 ... 20.
    float softness = 2.0f;                           ///< Angular radius of the key light [degrees], 0 ... 20.
    Eigen::Vector3f skyColor{0.55f, 0.68f, 0.9f};
    Eigen::Vector3f groundColor{0.32f, 0.30f, 0.28f};
};

enum class ColorBy : uint32_t { Body, Material, Particle, Speed };

struct RenderSettings {
    uint32_t width = 1280, height = 720;  ///< [pixels], 16 ... 8192
    CameraSettings camera;                ///< Of a film without shots.
    std::vector<Shot> shots;              ///< In order; empty: one camera, at the pace of the simulation.
    LightSettings light;
    ColorBy colorBy = ColorBy::Body;
    bool highlightJoints = false;  ///< Shared particles red, as in the paper's figures.
    bool markJoints = false;       ///< Joints and their limits in front of everything (jointMarks()).
    bool legend = false;           ///< Explains those marks.
    float skinOpacity = 1.0f;      ///< 0 ... 1; below 1 skins are veils over visible particles.
    float skinError = 0.65f;       ///< Tolerated error of far-off skins [pixels], 0 ... 100; 0: draws all triangles.
    float speedScale = 5.0f;       ///< ColorBy::Speed: the speed [m/s] at the end of the colour scale.
    float exposure = 1.0f;         ///< Linear factor before tone mapping, 0.01 ... 100.
    uint32_t antialiasing = 1;     ///< Samples per axis and pixel, 1 ... 4. Edges are always filtered; time grows with
                                   ///< the square.
};

/// @throws InputError for a value out of range.
void checkSettings(const RenderSettings& settings);

}  // namespace knuckle
