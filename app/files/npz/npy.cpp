#include "app/files/npz/npy.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>

#include "app/json/json.h"
#include "sim/base/utf8.h"

namespace knuckle {

namespace {

static_assert(std::endian::native == std::endian::little, "arrays get values as they lie in memory");

constexpr std::string_view MAGIC = "\x93NUMPY";
constexpr size_t HEADER_UNIT = 64;  // bytes: headers end at multiples

/// What the head of an array says.
struct NpyHead {
    bool isSwapped = false, isByColumns = false;
    char kind = 'f';
    size_t itemBytes = 8;  ///< Of texts: of all letters.
    std::vector<size_t> shape;
    size_t end = 0;  ///< Where the values begin.

    size_t count() const
    {
        size_t product = 1;
        for (const size_t extent : shape) {
            if (extent == 0) return 0;
            product = extent > SIZE_MAX / product ? SIZE_MAX : product * extent;
        }
        return product;
    }
};

/// The value of a key in the head's dictionary, up to what ends it.
std::string_view entryOf(std::string_view head, std::string_view key, char end)
{
    const size_t at = head.find(fmt::format("'{}'", key)), colon = head.find(':', at);
    if (at == std::string_view::npos || colon == std::string_view::npos) return {};
    const size_t start = std::min(head.find_first_not_of(' ', colon + 1), head.size());
    const size_t last = head.find(end, start + 1);
    return last == std::string_view::npos ? std::string_view{} : head.substr(start, last + 1 - start);
}

std::vector<size_t> numbersIn(std::string_view text)
{
    std::vector<size_t> numbers;
    for (size_t i = 0; i < text.size(); ++i) {
        if (std::isdigit(static_cast<unsigned char>(text[i])) == 0) continue;
        size_t number = 0;
        for (; i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0; ++i)
            number = number > SIZE_MAX / 16 ? SIZE_MAX : 10 * number + static_cast<size_t>(text[i] - '0');
        numbers.push_back(number);
    }
    return numbers;
}

/// The part of the file that describes the values. @returns nothing if it is none.
std::string_view dictionaryOf(std::string_view bytes, NpyHead& head)
{
    if (!bytes.starts_with(MAGIC) || bytes.size() < MAGIC.size() + 6) return {};
    const bool isOld = bytes[MAGIC.size()] == 1;
    uint32_t length = 0;
    std::memcpy(&length, bytes.data() + MAGIC.size() + 2, isOld ? 2 : 4);
    const size_t start = MAGIC.size() + (isOld ? 4 : 6);
    if (bytes.size() - start < length) return {};
    head.end = start + length;
    return bytes.substr(start, length);
}

NpyHead headOf(std::string_view bytes, const std::string& path, const std::string& name)
{
    NpyHead head;
    const std::string_view text = dictionaryOf(bytes, head);
    const std::string_view type = entryOf(text, "descr", '\''), shape = entryOf(text, "shape", ')');
    if (type.empty() || shape.empty())
        failAt(path, name, "is no array of NumPy, or ends early; save it again by numpy.savez");
    const std::vector<size_t> size = numbersIn(type);
    const bool isPlain = type.size() > 3 && type.front() == '\'' && size.size() == 1;
    head.kind = isPlain ? type[2] : 'O';
    head.itemBytes = isPlain ? std::min(size[0], bytes.size() + 1) * (head.kind == 'U' ? 4 : 1) : 0;
    const std::string_view sizes = head.kind == 'f' ? "\2\4\10" : "\1\2\4\10";
    const bool isText = head.kind == 'U' || head.kind == 'S';
    const bool isNumber = head.itemBytes <= 8 && std::string_view("fiub").find(head.kind) != std::string_view::npos &&
                          sizes.find(static_cast<char>(head.itemBytes)) != std::string_view::npos;
    if (!isText && !isNumber)
        failAt(path, name, fmt::format("is of the type {}; must be of numbers or of texts (str)", type));
    head.isSwapped = type[1] == '>';
    head.isByColumns = entryOf(text, "fortran_order", ',').starts_with("True");
    head.shape = numbersIn(shape);
    return head;
}

/// By rows, where each value stands among those by columns.
size_t placeByColumns(size_t index, const std::vector<size_t>& shape)
{
    size_t place = 0;
    std::vector<size_t> each(shape.size());
    for (size_t k = shape.size(); k-- > 0; index /= shape[k]) each[k] = index % shape[k];
    for (size_t k = shape.size(); k-- > 0;) place = place * shape[k] + each[k];
    return place;
}

template <typename T>
double valueAs(const char* bytes)
{
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return static_cast<double>(value);
}

/// Of sixteen bits, one for the sign and five for the exponent.
double halfOf(const char* bytes)
{
    uint16_t bits = 0;
    std::memcpy(&bits, bytes, 2);
    const int exponent = bits >> 10 & 31, fraction = bits & 1023;
    const double size = exponent == 31  ? (fraction == 0 ? INFINITY : NAN)
                        : exponent == 0 ? std::ldexp(fraction, -24)
                                        : std::ldexp(1024 + fraction, exponent - 25);
    return bits >> 15 != 0 ? -size : size;
}

double numberOf(const NpyHead& head, const char* bytes)
{
    const bool isSigned = head.kind == 'i';
    if (head.kind == 'f') {
        if (head.itemBytes == 2) return halfOf(bytes);
        return head.itemBytes == 4 ? valueAs<float>(bytes) : valueAs<double>(bytes);
    }
    switch (head.itemBytes) {
        case 1: return isSigned ? valueAs<int8_t>(bytes) : valueAs<uint8_t>(bytes);
        case 2: return isSigned ? valueAs<int16_t>(bytes) : valueAs<uint16_t>(bytes);
        case 4: return isSigned ? valueAs<int32_t>(bytes) : valueAs<uint32_t>(bytes);
        default: return isSigned ? valueAs<int64_t>(bytes) : valueAs<uint64_t>(bytes);
    }
}

std::string textOf(const NpyHead& head, std::string_view bytes)
{
    if (head.kind == 'S') return std::string(bytes.substr(0, bytes.find_last_not_of('\0') + 1));
    std::vector<uint32_t> points(bytes.size() / 4);
    std::memcpy(points.data(), bytes.data(), bytes.size());
    while (!points.empty() && points.back() == 0) points.pop_back();
    return utf8Of(points);
}

std::string fileOf(std::string_view type, const std::vector<size_t>& shape, std::string_view values)
{
    std::string head = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", type, shapeText(shape));
    const size_t before = MAGIC.size() + 4;
    const size_t whole = (before + head.size() + HEADER_UNIT) / HEADER_UNIT * HEADER_UNIT;
    head.resize(whole - before - 1, ' ');
    head += '\n';
    std::string bytes(MAGIC);
    bytes += '\1';
    bytes += '\0';
    bytes += static_cast<char>(head.size() & 0xff);
    bytes += static_cast<char>(head.size() >> 8);
    return bytes.append(head).append(values);
}

template <typename T>
std::string_view bytesOf(const std::vector<T>& values)
{
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

}  // namespace

NpyArray readNpy(std::string_view bytes, const std::string& path, const std::string& name)
{
    const NpyHead head = headOf(bytes, path, name);
    const size_t count = head.count(), room = bytes.size() - head.end;
    if (head.itemBytes > 0 && count > room / head.itemBytes)
        failAt(path, name,
               fmt::format("ends early: it has {} bytes for values of the shape {}", room, shapeText(head.shape)));
    NpyArray array;
    array.shape = head.shape;
    array.isText = head.kind == 'U' || head.kind == 'S';
    if (head.itemBytes == 0) {
        // Texts without a letter take no bytes.
        if (count > bytes.size()) failAt(path, name, fmt::format("has the shape {}", shapeText(head.shape)));
        array.texts.resize(count);
        return array;
    }
    const size_t unit = head.kind == 'U' ? 4 : head.kind == 'S' ? 1 : head.itemBytes;
    for (size_t i = 0; i < count; ++i) {
        const size_t place = head.isByColumns ? placeByColumns(i, head.shape) : i;
        std::string value(bytes.substr(head.end + place * head.itemBytes, head.itemBytes));
        for (size_t at = 0; head.isSwapped && at < value.size(); at += unit)
            std::reverse(value.begin() + static_cast<std::ptrdiff_t>(at),
                         value.begin() + static_cast<std::ptrdiff_t>(at + unit));
        if (array.isText) array.texts.push_back(textOf(head, value));
        else array.numbers.push_back(numberOf(head, value.data()));
    }
    return array;
}

std::string shapeText(std::span<const size_t> shape)
{
    return fmt::format("({}{})", fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
}

std::string npyOf(const std::vector<size_t>& shape, const std::vector<std::string>& texts)
{
    std::vector<std::vector<uint32_t>> letters;
    size_t longest = 1;
    for (const std::string& text : texts) {
        letters.push_back(codePointsOf(text));
        longest = std::max(longest, letters.back().size());
    }
    std::vector<uint32_t> all;
    for (std::vector<uint32_t>& each : letters) {
        each.resize(longest, 0);
        all.insert(all.end(), each.begin(), each.end());
    }
    return fileOf(fmt::format("<U{}", longest), shape, bytesOf(all));
}

std::string npyOf(const std::vector<size_t>& shape, const std::vector<bool>& flags)
{
    return fileOf("|b1", shape, std::string(flags.begin(), flags.end()));
}

std::string npyOf(const std::vector<size_t>& shape, const std::vector<int32_t>& values)
{
    return fileOf("<i4", shape, bytesOf(values));
}

std::string npyOf(const std::vector<size_t>& shape, const std::vector<float>& values)
{
    return fileOf("<f4", shape, bytesOf(values));
}

std::string npyOf(const std::vector<size_t>& shape, const std::vector<double>& values)
{
    return fileOf("<f8", shape, bytesOf(values));
}

}  // namespace knuckle
