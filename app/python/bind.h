#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "render/picture/image.h"

namespace knuckle {

/// Python's module of the program, in parts.
void bindScene(pybind11::module_& module);
void bindSimulation(pybind11::module_& module);
/// The part of the simulation's class that changes it.
void bindChanges(pybind11::class_<class Session>& simulation);
void bindActor(pybind11::module_& module);
void bindPictures(pybind11::module_& module);
void bindFilm(pybind11::module_& module);

/// A picture of uint8 [height, width, 3 or 4]: alpha does not count. @throws InputError for anything else.
Image imageOf(const pybind11::object& source);

/// What json.dumps() makes of it. @param other what is called for values that it does not know.
inline std::string jsonText(const pybind11::handle& value, const pybind11::object& other = pybind11::none())
{
    using pybind11::literals::operator""_a;
    return pybind11::module_::import("json").attr("dumps")(value, "default"_a = other).cast<std::string>();
}

/// For jsonText(): instead of an Actor the name of a file that has it, until the program ends.
pybind11::object fileOfActor();

/// float32 [n, 3], a copy.
inline pybind11::array_t<float> arrayOf(const std::vector<Eigen::Vector3f>& vectors)
{
    static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));
    const std::vector<pybind11::ssize_t> shape{static_cast<pybind11::ssize_t>(vectors.size()), 3};
    return pybind11::array_t<float>(shape, reinterpret_cast<const float*>(vectors.data()));
}

}  // namespace knuckle
