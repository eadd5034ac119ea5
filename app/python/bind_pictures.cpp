#include <pybind11/stl/filesystem.h>

#include "app/python/bind.h"
#include "render/compare/comparison.h"
#include "render/reader/picture_file.h"
#include "sim/base/errors.h"

namespace py = pybind11;
using namespace py::literals;

namespace knuckle {

namespace {

using Pixels = py::array_t<uint8_t, py::array::c_style | py::array::forcecast>;

/// A file, or uint8 [h, w, 3 or 4]: alpha does not count.
Picture pictureFrom(const py::object& source)
{
    if (!py::isinstance<py::array>(source)) return readPicture(source.cast<std::filesystem::path>().string());
    if (!py::isinstance<py::array_t<uint8_t>>(source)) throw InputError("a picture is an array of uint8");
    const auto pixels = source.cast<Pixels>();
    if (pixels.ndim() != 3 || pixels.shape(2) < 3 || pixels.shape(2) > 4)
        throw InputError("a picture is an array [height, width, 3 or 4]");
    const auto height = static_cast<uint32_t>(pixels.shape(0)), width = static_cast<uint32_t>(pixels.shape(1));
    const auto channels = static_cast<size_t>(pixels.shape(2));
    std::vector<uint8_t> rgb;
    rgb.reserve(size_t{3} * width * height);
    for (size_t i = 0; i < size_t{width} * height; ++i)
        rgb.insert(rgb.end(), pixels.data() + channels * i, pixels.data() + channels * i + 3);
    return pictureOf(width, height, rgb);
}

py::dict compared(const py::object& first, const py::object& second, float threshold)
{
    CompareSettings settings;
    settings.threshold = threshold;
    const PictureComparison found = comparePictures(pictureFrom(first), pictureFrom(second), settings);
    return py::dict("same_size"_a = found.sameSize(), "identical"_a = found.identical(),
                    "differing"_a = found.differences.differing, "changed"_a = found.differences.changed,
                    "flip"_a = found.flip.mean, "ssim"_a = found.ssim.mean);
}

}  // namespace

void bindPictures(py::module_& module)
{
    module.def("compare", &compared, "first"_a, "second"_a, "threshold"_a = 8.0f,
               "How two pictures differ, files or uint8 arrays [height, width, 3 or 4]; the first is the reference. A "
               "dict: 'same_size', 'identical', 'differing' pixels, those 'changed' by more than `threshold` of 255 in "
               "a channel, mean 'flip' and 'ssim'.");
}

}  // namespace knuckle
