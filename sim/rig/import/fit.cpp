#include "sim/rig/import/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "sim/base/errors.h"

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float LARGEST_FIGURE = 20.0f;                  // a taller figure cannot be in metres [m]
constexpr float SMALLEST = 0.005f, LARGEST = 200.0f;     // range of guessed sizes [m]
constexpr float PERSON = 1.7f;                           // height of a skeleton without a mesh [m]
constexpr float ODDLY_SMALL = 0.4f, ODDLY_LARGE = 4.0f;  // of a figure with a skeleton [m]
constexpr float FAR_AWAY = 10.0f;                        // from the origin, in sizes of the model

struct Unit {
    const char* name;
    float metres;
};
constexpr Unit UNITS[] = {{"metres", 1.0f}, {"centimetres", 0.01f}, {"millimetres", 0.001f}};
// Motion capture comes in these; the last is the unit of the CMU library (an inch over 0.45).
constexpr Unit CAPTURE_UNITS[] = {{"metres", 1.0f},
                                  {"centimetres", 0.01f},
                                  {"millimetres", 0.001f},
                                  {"decimetres", 0.1f},
                                  {"inches", 0.0254f},
                                  {"feet", 0.3048f},
                                  {"units of 56.4 mm", 0.0254f / 0.45f}};

/// Bounds of the mesh, or of the bones' heads without a mesh.
Eigen::AlignedBox3f boundsOf(const Model& model)
{
    Eigen::AlignedBox3f bounds;
    for (const Vector3f& vertex : model.vertices) bounds.extend(vertex);
    if (model.vertices.empty())
        for (const Bone& bone : model.bones) bounds.extend(headIn(bone.restPose));
    return bounds;
}

/// @param similarity a rotation, a scale and a shift.
void transform(Model& model, const Eigen::Affine3f& similarity)
{
    for (Vector3f& vertex : model.vertices) vertex = similarity * vertex;
    for (SurfaceVertex& vertex : model.surface.vertices)
        vertex.normal = (similarity.linear() * vertex.normal).normalized();
    for (Bone& bone : model.bones) bone.restPose = similarity * bone.restPose;
    for (Clip& clip : model.clips)
        for (auto& pose : clip.poses)
            for (Eigen::Matrix4f& matrix : pose) matrix = similarity * matrix;
}

/// Guesses the file's unit: for a figure too large for metres, one that gives a plausible size; for a skeleton without
/// a mesh, the one that makes it as tall as a person.
const Unit& guessUnit(const Model& model, float size)
{
    if (model.triangles.empty())
        return *std::min_element(std::begin(CAPTURE_UNITS), std::end(CAPTURE_UNITS), [&](const Unit& a, const Unit& b) {
            return std::abs(std::log(size * a.metres / PERSON)) < std::abs(std::log(size * b.metres / PERSON));
        });
    for (const Unit& unit : UNITS)
        if (size * unit.metres <= LARGEST_FIGURE) return unit;
    return UNITS[0];
}

/// Metres per unit of the file.
float scaleOf(Model& model, const ModelFit& fit, const Vector3f& size)
{
    if (fit.height > 0.0) {
        if (!(size.y() > 0.0f)) throw InputError("it has no height that could be changed; give --scale");
        return static_cast<float>(fit.height) / size.y();
    }
    if (fit.scale > 0.0) return static_cast<float>(fit.scale);
    const Unit& unit = guessUnit(model, size.maxCoeff());
    if (unit.metres != 1.0f)
        model.notes.push_back(fmt::format("The model measures {:.4g} units: taken for {}, so {:.3g} m.",
                                          size.maxCoeff(), unit.name, size.maxCoeff() * unit.metres));
    return unit.metres;
}

/// Notes a figure that is no person's size if no option gives its size.
void questionSize(Model& model, const Vector3f& size)
{
    const float largest = size.maxCoeff();
    if (model.bones.size() < 2 || model.isSplit || (largest >= ODDLY_SMALL && largest <= ODDLY_LARGE)) return;
    const char* side = largest == size.y() ? "high" : "across";
    model.notes.push_back(
        fmt::format("The figure is {:.3g} m {}, {}. If that is not meant, give its height: --height 1.8.", largest,
                    side, largest < ODDLY_SMALL ? "small for one that moves" : "larger than people and most animals"));
}

void center(Model& model, Centering centering)
{
    const Eigen::AlignedBox3f bounds = boundsOf(model);
    const Vector3f middle = bounds.center();
    const bool isFar = middle.norm() > FAR_AWAY * bounds.sizes().maxCoeff();
    if (centering == Centering::Never || (centering == Centering::WhereFar && !isFar)) return;
    if (centering == Centering::WhereFar)
        model.notes.push_back(
            fmt::format("The model stood {:.3g} m from its origin and was moved there.", middle.norm()));
    transform(model, Eigen::Affine3f(Eigen::Translation3f(-middle.x(), -bounds.min().y(), -middle.z())));
}

}  // namespace

void fitModel(Model& model, const ModelFit& fit)
{
    if (fit.up == UpAxis::Z)
        transform(model, Eigen::Affine3f(Eigen::AngleAxisf(-0.5f * std::numbers::pi_v<float>, Vector3f::UnitX())));
    const Vector3f size = boundsOf(model).sizes();
    if (!size.allFinite() || !(size.maxCoeff() > 0.0f))
        throw InputError("it has no size, or one that is not finite: check the transforms in the file");
    const float factor = scaleOf(model, fit, size), metres = size.maxCoeff() * factor;
    if (!(metres >= SMALLEST && metres <= LARGEST))
        throw InputError(
            fmt::format("it would be {:.3g} m large, {:g} to {:g} m are possible: give --height, or --scale "
                        "(in scenes `scale`), in metres per unit (the file has {:.4g} units)",
                        metres, SMALLEST, LARGEST, size.maxCoeff()));
    if (factor != 1.0f) transform(model, Eigen::Affine3f(Eigen::Scaling(factor)));
    if (fit.height == 0.0 && fit.scale == 0.0) questionSize(model, factor * size);
    center(model, fit.centering);
}

}  // namespace knuckle
