#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace knuckle {

/// The ink of a letter, 0 to 255, top row first.
struct Glyph {
    int left = 0, top = 0;  ///< Of the ink, from the pen's place on the base line [pixels]; down is positive.
    int width = 0, height = 0;
    std::vector<uint8_t> ink;
};

/// Letters of a TrueType file, each drawn once for a size.
class Font {
public:
    /// @throws InputError, naming the package to install, if there is no such file; and if it is no font.
    explicit Font(const std::string& path);
    ~Font();
    Font(const Font&) = delete;
    Font& operator=(const Font&) = delete;

    /// @param size height of a line [pixels].
    const Glyph& glyph(uint32_t codePoint, int size);
    /// From the pen's place to the next letter's [pixels].
    float advance(uint32_t codePoint, uint32_t next, int size) const;
    float width(std::string_view text, int size) const;
    /// Of the base line below the upper end of a line [pixels].
    float ascent(int size) const;

private:
    struct File;
    std::unique_ptr<File> file_;
    std::map<std::pair<uint32_t, int>, Glyph> glyphs_;
};

}  // namespace knuckle
