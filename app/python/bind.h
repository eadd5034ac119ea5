#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/json/json.h"
#include "app/python/session_end.h"
#include "render/picture/image.h"

namespace knuckle {

using SessionClass = pybind11::class_<Session, SessionHolder>;

/// Python's module of the program, in parts.
void bindScene(pybind11::module_& module);
void bindSimulation(pybind11::module_& module);
/// The part of the simulation's class that changes it.
void bindChanges(SessionClass& simulation);
void bindActor(pybind11::module_& module);
void bindPictures(pybind11::module_& module);
void bindFilm(pybind11::module_& module);

/// A picture of uint8 [height, width, 3 or 4]: alpha does not count. @throws InputError for anything else.
Image imageOf(const pybind11::object& source);

/// The name of a file that stands for a value of Python in a scene; empty: none does.
using FileOf = std::function<std::string(const pybind11::handle&)>;

/// Dicts, lists, tuples, texts, paths and numbers, arrays of NumPy as well. @param where named in errors.
/// @param fileOf asked for what is none of these. @throws InputError with the pointer of a number that is not finite,
/// of a key that is no text; TypeError for other types.
Json jsonOf(const pybind11::handle& value, const std::string& where, const FileOf& fileOf = {},
            const std::string& pointer = {}, int depth = 0);

/// For jsonOf(): of an Actor a file that has it, until the program ends.
std::string fileOfActor(const pybind11::handle& value);

/// Refuses a NumPy masked array with masked entries, of which other functions of NumPy take what lies below the mask.
/// @param name in the error. @throws InputError.
void requireUnmasked(const pybind11::handle& value, const std::string& name);

/// What a value is, in one short line for an error.
std::string said(const pybind11::handle& value);

/// float32 [n, 3], a copy.
inline pybind11::array_t<float> arrayOf(const std::vector<Eigen::Vector3f>& vectors)
{
    static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));
    const std::vector<pybind11::ssize_t> shape{static_cast<pybind11::ssize_t>(vectors.size()), 3};
    return pybind11::array_t<float>(shape, reinterpret_cast<const float*>(vectors.data()));
}

}  // namespace knuckle
