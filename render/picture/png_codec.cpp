// The only file with stb's code for frames, whose deflate is replaced by libdeflate's.
#include <libdeflate.h>

#include <cstdlib>

namespace knuckle {

/// libdeflate's level for pictures that this thread encodes; image.cpp sets it.
thread_local int deflateLevel = 1;

}  // namespace knuckle

namespace {

unsigned char* compressZlib(unsigned char* data, int byteCount, int* compressedBytes, int)
{
    libdeflate_compressor* compressor = libdeflate_alloc_compressor(knuckle::deflateLevel);
    if (compressor == nullptr) return nullptr;
    const auto size = static_cast<size_t>(byteCount);
    const size_t bound = libdeflate_zlib_compress_bound(compressor, size);
    // stb frees it.
    auto* out = static_cast<unsigned char*>(std::malloc(bound));
    const size_t written = out != nullptr ? libdeflate_zlib_compress(compressor, data, size, out, bound) : 0;
    libdeflate_free_compressor(compressor);
    *compressedBytes = static_cast<int>(written);
    return out;
}

}  // namespace

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STBIW_ZLIB_COMPRESS compressZlib
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>
#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_FAILURE_USERMSG
#include <stb/stb_image.h>
#pragma GCC diagnostic pop
