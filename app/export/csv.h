#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace knuckle {

/// A cell of a CSV file, quoted if necessary.
std::string csvCell(const std::string& text);

/// The cells of a line that has no line end in a quoted one.
std::vector<std::string> csvCells(std::string_view line);

}  // namespace knuckle
