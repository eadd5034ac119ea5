#include <fmt/format.h>
#include <pybind11/stl/filesystem.h>

#include "app/python/bind.h"
#include "render/compare/comparison.h"
#include "render/reader/picture_file.h"
#include "sim/base/errors.h"

namespace py = pybind11;
using namespace py::literals;

namespace knuckle {

namespace {

/// A file, or what imageOf() takes.
Picture pictureFrom(const py::object& source)
{
    const bool isPath = py::isinstance<py::str>(source) || py::hasattr(source, "__fspath__");
    if (isPath) return readPicture(source.cast<std::filesystem::path>().string());
    const Image image = imageOf(source);
    return pictureOf(image.width, image.height, image.rgb);
}

py::dict compared(const py::object& first, const py::object& second, float threshold)
{
    if (!(threshold >= 0.0f && threshold <= 255.0f))
        throw InputError(fmt::format("threshold must be from 0 to 255; it is {}", threshold));
    CompareSettings settings;
    settings.threshold = threshold;
    const PictureComparison found = comparePictures(pictureFrom(first), pictureFrom(second), settings);
    if (!found.sameSize())
        return py::dict("same_size"_a = false, "identical"_a = false, "differing"_a = py::none(),
                        "changed"_a = py::none(), "flip"_a = py::none(), "ssim"_a = py::none());
    return py::dict("same_size"_a = true, "identical"_a = found.identical(),
                    "differing"_a = found.differences.differing, "changed"_a = found.differences.changed,
                    "flip"_a = found.flip.mean, "ssim"_a = found.ssim.mean);
}

}  // namespace

Image imageOf(const py::object& source)
{
    using Pixels = py::array_t<uint8_t, py::array::c_style | py::array::forcecast>;
    if (!py::isinstance<py::array_t<uint8_t>>(source))
        throw InputError(fmt::format("a picture is an array of uint8, not {}", said(source)));
    requireUnmasked(source, "a picture");
    const auto pixels = source.cast<Pixels>();
    if (pixels.ndim() != 3 || pixels.shape(2) < 3 || pixels.shape(2) > 4 || pixels.size() == 0)
        throw InputError(fmt::format("a picture is an array [height, width, 3 or 4], not {}", said(source)));
    Image image{static_cast<uint32_t>(pixels.shape(1)), static_cast<uint32_t>(pixels.shape(0))};
    const auto channels = static_cast<size_t>(pixels.shape(2));
    const size_t count = size_t{image.width} * image.height;
    image.rgb.reserve(3 * count);
    for (size_t i = 0; i < count; ++i)
        image.rgb.insert(image.rgb.end(), pixels.data() + channels * i, pixels.data() + channels * i + 3);
    return image;
}

void bindPictures(py::module_& module)
{
    module.def("compare", &compared, "first"_a, "second"_a, "threshold"_a = 8.0f,
               "How two pictures differ, files or uint8 arrays [height, width, 3 or 4]; the first is the reference. A "
               "dict: 'same_size', 'identical', 'differing' pixels, those 'changed' by more than `threshold` of 255 in "
               "a channel, mean 'flip' and 'ssim'; the last four are None for pictures of different sizes.");
}

}  // namespace knuckle
