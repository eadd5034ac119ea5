#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/camera_settings.h"
#include "render/sky/sky_map.h"

namespace knuckle {

struct LightSettings {
    Eigen::Vector3f direction{-0.5f, 0.85f, 0.45f};  ///< Towards the key light; normalized when used.
    float intensity = 3.0f;                          ///< Key light, 0 ... 20.
    float softness = 2.0f;                           ///< Angular radius of the key light [degrees], 0 ... 20.
    Eigen::Vector3f skyColor{0.55f, 0.68f, 0.9f};
    Eigen::Vector3f groundColor{0.32f, 0.30f, 0.28f};
    Eigen::Vector3f color{1.0f, 0.955f, 0.89f};  ///< Of the key light.
    float bounce = 0.0f;                         ///< How much the ground's light counts on what is near it, 0 ... 1.
    std::shared_ptr<const SkyMap> sky;           ///< What is behind everything; null: a gradient of those colours.
    std::string skyFile;                         ///< Of a picture that `sky` is to be; empty: none.
    bool takesSkyColor = false;                  ///< skyColor is to come from that picture.
    bool takesGroundColor = false;               ///< The same of groundColor.
};

/// A light beside the key light. It casts shadows of what the camera sees.
struct LightSource {
    bool isPoint = true;
    Eigen::Vector3f place{0, 2, 0};  ///< Of a point [m]; otherwise towards it, normalized when used.
    Eigen::Vector3f color{1, 1, 1};
    float intensity = 3.0f;  ///< As of the key light; of a point, at a distance of 1 m. 0 ... 1000.
};

/// As many as a scene may have.
inline constexpr size_t LIGHT_SOURCES = 4;

/// How light becomes a displayed colour.
enum class ToneMap : uint32_t { Film, Neutral, Agx, Linear };

/// What is where nothing is.
enum class Background : uint32_t { Sky, Transparent, Color };

enum class ColorBy : uint32_t { Body, Material, Particle, Speed, Pressure, Density, Strain, Age, ContactForce };

/// Of quantities, see palette.cpp.
enum class Palette : uint32_t { Auto, Heat, Viridis, Cividis, Turbo, Diverging };

/// Where a text stands in the picture.
enum class TextPlace : uint32_t { Top, TopLeft, TopRight, Center, Bottom, BottomLeft, BottomRight };

/// Words over the picture for a while.
struct Caption {
    std::string text;  ///< UTF-8; lines are broken where it says so, and where they do not fit.
    float from = 0.0f;
    float to = 0.0f;  ///< Times of the film [s]: from <= t < to; 0: to the end.
    TextPlace at = TextPlace::Bottom;
    float size = 0.05f;  ///< Height of a line, as a share of the picture's height, 0.01 ... 0.5.
};

/// What is written and drawn over the finished picture.
struct OverlaySettings {
    std::string title;
    std::vector<Caption> captions;
    bool frame = false, time = false, scaleBar = false, colorBar = false;
    double framesPerSecond = 60.0;  ///< Of the film, for its frames' numbers.
    std::string font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

    bool hasText() const { return !title.empty() || !captions.empty() || frame || time || scaleBar || colorBar; }
};

/// How much work a picture is.
enum class Quality : uint32_t {
    Draft,  ///< Drawn at half the size and enlarged.
    Good,
    Final  ///< The mean of several draws, each a little beside the others; dithered.
};

/// Light that thin air between the eye and things swallows and gives.
struct FogSettings {
    float density = 0.0f;                        ///< At the ground's height [1/m], 0 ... 100; 0: none.
    Eigen::Vector3f color{0.62f, 0.68f, 0.75f};  ///< Linear RGB, before the exposure.
    float falloff = 0.0f;                        ///< It thins upwards by e every 1/falloff [1/m], 0 ... 100.
};

struct RenderSettings {
    uint32_t width = 1280, height = 720;            ///< [pixels], 16 ... 8192
    CameraSettings camera;                          ///< Of a film without shots.
    std::vector<Shot> shots;                        ///< In order; empty: one camera, at the pace of the simulation.
    std::map<std::string, CameraSettings> cameras;  ///< All that have a name, see filmedBy().
    LightSettings light;
    ColorBy colorBy = ColorBy::Body;
    bool highlightJoints = false;  ///< Shared particles red, as in the paper's figures.
    bool markJoints = false;       ///< Joints and their limits in front of everything (jointMarks()).
    bool legend = false;           ///< Explains those marks.
    float skinOpacity = 1.0f;      ///< 0 ... 1; below 1 skins are veils over visible particles.
    float skinError = 0.65f;       ///< Tolerated error of far-off skins [pixels], 0 ... 100; 0: draws all triangles.
    float speedScale = 5.0f;       ///< ColorBy::Speed: the speed [m/s] at the end of the colour scale.
    std::optional<Eigen::Vector2f> colorScale;  ///< Low and high end, in the quantity's unit; none: colorScaleOf().
    Palette palette = Palette::Auto;            ///< Of quantities.
    OverlaySettings overlay;
    uint32_t depth = 8;     ///< Bits of a channel of the finished picture, 8 or 16.
    float exposure = 1.0f;  ///< Linear factor before tone mapping, 0.01 ... 100.
    ToneMap toneMap = ToneMap::Film;
    Background background = Background::Sky;
    Eigen::Vector3f backgroundColor{0, 0, 0};  ///< Linear RGB, before the exposure.
    std::vector<LightSource> lights;           ///< Beside LightSettings' key light, at most LIGHT_SOURCES.
    Quality quality = Quality::Good;
    uint32_t samples = 0;   ///< Draws of a frame, up to MOST_SAMPLES; 0: see drawsOf().
    float shutter = 0.0f;   ///< How much of the time between frames one is exposed to [degrees], 0 ... 360.
    float bloom = 0.0f;     ///< Share of the light that is spread over the picture, 0 ... 1.
    float vignette = 0.0f;  ///< Share of the light that corners lack, 0 ... 1.
    FogSettings fog;
    bool layers = false;        ///< Drawn as numbers instead of a picture, see layerSettings().
    uint32_t antialiasing = 1;  ///< Samples per axis and pixel, 1 ... 4. Edges are always filtered; time grows with
                                ///< the square.
};

/// Whether colours show a number.
inline bool showsQuantity(const RenderSettings& settings)
{
    return settings.colorBy >= ColorBy::Speed;
}

/// The same film, every shot of it by one of its cameras alone. @throws std::out_of_range for an unknown name.
RenderSettings filmedBy(const RenderSettings& settings, const std::string& camera);

/// @throws InputError for a value out of range.
void checkSettings(const RenderSettings& settings);

inline constexpr uint32_t MOST_SAMPLES = 64;
/// How many draws a frame is the mean of: `samples`, else as many as what is blurred needs, or the quality.
uint32_t drawsOf(const RenderSettings& settings);
/// Whether draws are light, from which pictures are developed, instead of displayed colours.
bool hasLens(const RenderSettings& settings);
/// Pixels of one draw, before those of antialiasing.
struct DrawnSize {
    uint32_t width, height;
};
DrawnSize drawnSize(const RenderSettings& settings);

}  // namespace knuckle
