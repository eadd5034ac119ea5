// Values of Python as JSON.
#include <fmt/format.h>

#include <cmath>

#include "app/python/bind.h"
#include "sim/base/errors.h"

namespace py = pybind11;

namespace knuckle {

namespace {

/// Deeper than any scene; what contains itself never ends.
constexpr int DEEPEST = 100;

[[noreturn]] void fail(const std::string& where, const std::string& pointer, const std::string& what)
{
    throw InputError(fmt::format("{}: {} {}", where, pointer.empty() ? "/" : pointer, what));
}

std::string textOf(const py::handle& value, const std::string& where, const std::string& pointer)
{
    Py_ssize_t size = 0;
    const char* bytes = PyUnicode_AsUTF8AndSize(value.ptr(), &size);
    if (bytes == nullptr) {
        PyErr_Clear();
        fail(where, pointer, "is no text: half of a pair of surrogates");
    }
    return {bytes, static_cast<size_t>(size)};
}

Json numberOf(const py::handle& value, const std::string& where, const std::string& pointer)
{
    if (py::isinstance<py::float_>(value)) {
        const auto number = value.cast<double>();
        if (!std::isfinite(number)) fail(where, pointer, fmt::format("is {}, must be finite", number));
        return number;
    }
    int overflow = 0;
    const long long integer = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
    if (overflow != 0) fail(where, pointer, "is too large a number");
    return integer;
}

}  // namespace

Json jsonOf(const py::handle& value, const std::string& where, const FileOf& fileOf, const std::string& pointer,
            int depth)
{
    if (depth > DEEPEST) fail(where, pointer.substr(0, 40) + " ...", "is nested too deeply, or contains itself");
    const auto inner = [&](const py::handle& part, const std::string& name) {
        return jsonOf(part, where, fileOf, pointer + "/" + name, depth + 1);
    };
    if (value.is_none()) return nullptr;
    if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
    if (py::isinstance<py::float_>(value) || py::isinstance<py::int_>(value)) return numberOf(value, where, pointer);
    if (py::isinstance<py::str>(value)) return textOf(value, where, pointer);
    if (py::isinstance<py::dict>(value)) {
        Json object = Json::object();
        for (const auto& [key, part] : py::reinterpret_borrow<py::dict>(value)) {
            if (!py::isinstance<py::str>(key)) fail(where, pointer, fmt::format("has the key {}, no text", said(key)));
            const std::string name = textOf(key, where, pointer);
            object[name] = inner(part, name);
        }
        return object;
    }
    if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
        Json array = Json::array();
        for (const py::handle part : value) array.push_back(inner(part, std::to_string(array.size())));
        return array;
    }
    // Arrays and single numbers of NumPy.
    if (py::hasattr(value, "tolist")) return jsonOf(value.attr("tolist")(), where, fileOf, pointer, depth + 1);
    if (py::hasattr(value, "__fspath__")) return jsonOf(value.attr("__fspath__")(), where, fileOf, pointer, depth + 1);
    if (const std::string file = fileOf ? fileOf(value) : std::string{}; !file.empty()) return file;
    throw py::type_error("a scene has no values of the type " + py::str(py::type::of(value)).cast<std::string>());
}

void requireUnmasked(const py::handle& value, const std::string& name)
{
    if (py::hasattr(value, "mask") && py::module_::import("numpy").attr("ma").attr("is_masked")(value).cast<bool>())
        throw InputError(fmt::format("{} has masked entries; fill them, as with .filled()", name));
}

std::string said(const py::handle& value)
{
    constexpr size_t MOST = 60;
    if (py::isinstance<py::array>(value)) {
        const auto array = py::reinterpret_borrow<py::array>(value);
        return fmt::format("an array of {} {}", py::str(array.dtype()).cast<std::string>(),
                           py::str(array.attr("shape")).cast<std::string>());
    }
    // One line of ASCII: by split() and join() blanks and line breaks become a single blank.
    const std::string text = py::str(" ")
                                 .attr("join")(py::module_::import("builtins").attr("ascii")(value).attr("split")())
                                 .cast<std::string>();
    return text.size() <= MOST ? text : text.substr(0, MOST) + " ...";
}

}  // namespace knuckle
