// Films and frames of pictures that a program draws.
#include <fmt/format.h>
#include <pybind11/stl/filesystem.h>

#include "app/python/bind.h"
#include "render/output/film_kinds.h"
#include "render/output/frame_sink.h"
#include "sim/base/errors.h"
#include "sim/base/files/endings.h"

namespace py = pybind11;
using namespace py::literals;

namespace knuckle {

namespace {

/// A film, or frames by a pattern; its size is that of the first picture.
class Film {
public:
    Film(const std::filesystem::path& path, double framesPerSecond, std::string codec)
        : path_(path.string()), framesPerSecond_(framesPerSecond), codec_(std::move(codec))
    {
        if (!(framesPerSecond > 0.0 && framesPerSecond <= 480.0))
            throw InputError(fmt::format("fps must be above 0, at most 480; it is {}", framesPerSecond));
        // Pictures have 8 bits, and EXR has light.
        const std::string ending = endingOf(path_);
        const bool frames = path_.ends_with('/') || ending.empty() || std::filesystem::is_directory(path) ||
                            (FrameNames::areGivenBy(path_) && ending != ".exr");
        if (!frames && filmKindOf(path_) == nullptr)
            throw InputError(fmt::format("{}: films are written as {}, frames as name_####.png, or into a folder "
                                         "without an ending",
                                         path_, choiceOf(FILM_ENDINGS)));
    }

    /// @param picture uint8 [height, width, 3 or 4]; alpha does not count.
    void add(const py::object& picture)
    {
        Image image = imageOf(picture);
        if (isClosed_) throw InputError(fmt::format("{}: the film is closed", path_));
        if (!sink_) open(image);
        if (image.width != width_ || image.height != height_)
            throw InputError(fmt::format("{}: a picture of {}x{} in a film of {}x{}", path_, image.width, image.height,
                                         width_, height_));
        sink_->write(std::move(image), ++count_);
    }

    void close()
    {
        if (!sink_) return;
        sink_->finish();
        sink_.reset();
        isClosed_ = true;
    }

    /// Nothing is left of a film that is not closed.
    void giveUp()
    {
        sink_.reset();
        isClosed_ = true;
    }

    uint64_t count() const { return count_; }

private:
    void open(const Image& first)
    {
        width_ = first.width, height_ = first.height;
        if (filmKindOf(path_) != nullptr) sink_ = filmSink(path_, {width_, height_, framesPerSecond_, codec_});
        else sink_ = pictureSink(FrameNames::of(path_));
    }

    std::string path_;
    double framesPerSecond_;
    std::string codec_;
    std::unique_ptr<FrameSink> sink_;
    uint32_t width_ = 0, height_ = 0;
    uint64_t count_ = 0;
    bool isClosed_ = false;
};

}  // namespace

void bindFilm(py::module_& module)
{
    py::class_<Film>(
        module, "Film",
        "Writes pictures as a film, of the kind that its name's ending says (.mp4, .webm, .gif, .webp ..., "
        "through the program ffmpeg), or as frames (a folder, or 'name_####.png'). In a `with` block it is "
        "complete at the end, and not there at all if the block fails.")
        .def(py::init<const std::filesystem::path&, double, std::string>(), "path"_a, "fps"_a = 60.0, "codec"_a = "",
             "`fps`: frames a second. `codec`: as of `knuckle render --codec`; empty: the kind's own.")
        .def("add", &Film::add, "picture"_a, "The next frame, uint8 [height, width, 3 or 4]; all have one size.")
        .def("close", &Film::close, "Waits until it is written. Raises RunError if it could not be, as on a full disk.")
        .def_property_readonly("frames", &Film::count, "How many were added.")
        .def(
            "__enter__", [](Film& film) -> Film& { return film; }, py::return_value_policy::reference)
        .def("__exit__", [](Film& film, const py::object& type, const py::object&, const py::object&) {
            if (type.is_none()) film.close();
            else film.giveUp();
        });
}

}  // namespace knuckle
