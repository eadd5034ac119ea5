#pragma once

#include <array>

#include "render/settings.h"
#include "sim/world/world.h"

namespace knuckle {

/// The words of an enum in the order of its values.
template <typename T>
struct EnumWords;
template <>
struct EnumWords<SolverKind> {
    static constexpr std::array WORDS{"impulse", "paper"};
};
template <>
struct EnumWords<RotationMethod> {
    static constexpr std::array WORDS{"quaternion", "householder", "higham"};
};
template <>
struct EnumWords<GridKind> {
    static constexpr std::array WORDS{"lattice", "hash"};
};
template <>
struct EnumWords<ReductionKind> {
    static constexpr std::array WORDS{"auto", "thread", "group", "steps"};
};
template <>
struct EnumWords<VelocityOrder> {
    static constexpr std::array WORDS{"", "first", "second"};
};
template <>
struct EnumWords<JointType> {
    static constexpr std::array WORDS{"ball", "hinge", "stiff", "universal"};
};
template <>
struct EnumWords<CameraKind> {
    static constexpr std::array WORDS{"fixed", "orbit", "follow"};
};
template <>
struct EnumWords<Corner> {
    static constexpr std::array WORDS{"topLeft", "topRight", "bottomLeft", "bottomRight"};
};
template <>
struct EnumWords<Easing> {
    static constexpr std::array WORDS{"smooth", "linear", "easeIn", "easeOut", "easeInOut", "hold"};
};
template <>
struct EnumWords<ColorBy> {
    static constexpr std::array WORDS{"body",    "material", "particle", "speed",       "pressure",
                                      "density", "strain",   "age",      "contactForce"};
};
template <>
struct EnumWords<Palette> {
    static constexpr std::array WORDS{"auto", "heat", "viridis", "cividis", "turbo", "diverging"};
};
template <>
struct EnumWords<TextPlace> {
    static constexpr std::array WORDS{"top", "topLeft", "topRight", "center", "bottom", "bottomLeft", "bottomRight"};
};

template <>
struct EnumWords<FieldKind> {
    static constexpr std::array WORDS{"pull", "push", "swirl", "blow"};
};
template <>
struct EnumWords<FieldFalloff> {
    static constexpr std::array WORDS{"none", "linear", "inverseSquare"};
};

template <>
struct EnumWords<DrawnAs> {
    static constexpr std::array WORDS{"auto", "particles", "surface", "shape"};
};

template <>
struct EnumWords<Finish> {
    static constexpr std::array WORDS{"default", "matte", "plastic", "clay",    "wax",   "rubber",
                                      "metal",   "wood",  "checker", "brushed", "glass", "model"};
};
template <>
struct EnumWords<FloorLook> {
    static constexpr std::array WORDS{"default", "studio", "tiles",  "checker", "wood",
                                      "grass",   "grid",   "mirror", "none"};
};
template <>
struct EnumWords<ToneMap> {
    static constexpr std::array WORDS{"film", "neutral", "agx", "linear"};
};

template <>
struct EnumWords<Quality> {
    static constexpr std::array WORDS{"draft", "good", "final"};
};

}  // namespace knuckle
