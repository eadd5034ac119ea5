#include "render/reader/picture_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "render/reader/decoders.h"
#include "sim/base/errors.h"
#include "sim/base/files/file_descriptor.h"
#include "sim/base/files/output_place.h"

namespace knuckle {

namespace {

constexpr size_t MAX_BYTES = size_t{2} << 30;
/// A pixel of the picture, of what its decoder holds meanwhile, and of what a comparison makes of it.
constexpr size_t PIXEL_BYTES = 32;

/// Memory that the system can still give [bytes]; 0: not known.
uint64_t availableMemory()
{
    std::ifstream facts("/proc/meminfo");
    std::string word;
    uint64_t kibibytes = 0;
    while (facts >> word)
        if (word == "MemAvailable:" && facts >> kibibytes) return kibibytes << 10;
    return 0;
}

}  // namespace

void failPicture(const std::string& name, const std::string& reason)
{
    throw InputError(fmt::format("image {} cannot be read: {}", shownPath(name), reason));
}

void checkPictureSize(uint64_t width, uint64_t height, const std::string& name)
{
    if (width == 0 || height == 0) failPicture(name, "it has no pixels");
    const uint64_t most = MAX_PICTURE_PIXELS;
    if (width > most || height > most || width * height > most)
        failPicture(name,
                    fmt::format("{} x {} pixels are more than the {} that fit; cut or shrink it", width, height, most));
    const uint64_t needed = width * height * PIXEL_BYTES, available = availableMemory();
    if (available != 0 && needed > available)
        failPicture(name, fmt::format("{} x {} pixels need {} MiB, and {} MiB of memory are free; cut or shrink it",
                                      width, height, needed >> 20, available >> 20));
}

std::string utf8OfLatin1(std::string_view text)
{
    std::string utf8;
    for (const char letter : text) {
        const auto code = static_cast<unsigned char>(letter);
        if (code < 0x80) {
            utf8 += letter;
        } else {
            utf8 += static_cast<char>(0xc0 | (code >> 6));
            utf8 += static_cast<char>(0x80 | (code & 0x3f));
        }
    }
    return utf8;
}

std::string readPictureBytes(const std::string& path)
{
    const auto fail = [&](const char* reason) {
        throw InputError(fmt::format("image {} cannot be opened: {}", shownPath(path), reason));
    };
    const FileDescriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY));
    if (file.get() < 0) fail(std::strerror(errno));
    struct stat facts = {};
    if (fstat(file.get(), &facts) == 0 && S_ISDIR(facts.st_mode)) fail("it is a folder; name a picture in it");
    std::string bytes;
    if (S_ISREG(facts.st_mode)) bytes.reserve(std::min(MAX_BYTES, static_cast<size_t>(facts.st_size)));
    std::array<char, size_t{1} << 16> block;
    for (;;) {
        const ssize_t count = read(file.get(), block.data(), block.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(std::strerror(errno));
        if (count == 0) break;
        bytes.append(block.data(), static_cast<size_t>(count));
        if (bytes.size() > MAX_BYTES) failPicture(path, "it has more than 2 GiB; shrink it");
    }
    if (bytes.empty()) failPicture(path, "it is empty; write it anew");
    return bytes;
}

Picture decodePicture(std::string_view bytes, const std::string& name)
{
    if (bytes.starts_with("\x89PNG")) return decodePng(bytes, name);
    if (bytes.starts_with("\xff\xd8")) return decodeJpeg(bytes, name);
    if (bytes.starts_with("\x76\x2f\x31\x01")) return decodeExr(bytes, name);
    failPicture(name, "it is none of PNG, JPEG and EXR; convert it to one of them");
}

Picture readPicture(const std::string& path)
{
    return decodePicture(readPictureBytes(path), path);
}

}  // namespace knuckle
