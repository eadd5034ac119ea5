#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace knuckle {

/// An array of NumPy: numbers, which are exact up to 2^53, or texts, by rows.
struct NpyArray {
    std::vector<size_t> shape;  ///< Empty: a single value.
    bool isText = false;
    std::vector<double> numbers;
    std::vector<std::string> texts;  ///< UTF-8.
};

/// Reads a `.npy` of versions 1 to 3: booleans, integers, floats of 2 to 8 bytes, texts; of either byte order, by rows
/// or by columns. @param path, name of the file and the array, for errors.
/// @throws InputError for another type, and for bytes that end early.
NpyArray readNpy(std::string_view bytes, const std::string& path, const std::string& name);

/// "(10, 3)", as Python writes it.
std::string shapeText(std::span<const size_t> shape);

/// The `.npy` of texts, of booleans, or of numbers of a type.
std::string npyOf(const std::vector<size_t>& shape, const std::vector<std::string>& texts);
std::string npyOf(const std::vector<size_t>& shape, const std::vector<bool>& flags);
std::string npyOf(const std::vector<size_t>& shape, const std::vector<int32_t>& values);
std::string npyOf(const std::vector<size_t>& shape, const std::vector<float>& values);
std::string npyOf(const std::vector<size_t>& shape, const std::vector<double>& values);

}  // namespace knuckle
