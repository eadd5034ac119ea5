// The Python module: classes as in the scene file's words, errors as exceptions.
#include "app/python/bind.h"
#include "sim/base/errors.h"

namespace py = pybind11;

PYBIND11_MODULE(_knuckle, module)
{
    using namespace knuckle;
    module.doc() = "The compiled part of the package knuckle.";
    module.attr("__version__") = KNUCKLE_VERSION;
    py::register_exception<InputError>(module, "InputError", PyExc_ValueError).doc() =
        "Something that was given is wrong: one line with what, where (file, JSON pointer) and the remedy.";
    py::register_exception<RunError>(module, "RunError", PyExc_RuntimeError).doc() =
        "A run could not go on, as with a state that is no longer finite.";
    py::register_exception<DeviceError>(module, "DeviceError", PyExc_RuntimeError).doc() =
        "There is no OpenGL 4.3, or not enough of it.";
    bindScene(module);
    bindActor(module);
    bindSimulation(module);
    bindPictures(module);
    bindFilm(module);
}
