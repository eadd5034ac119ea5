#include "app/export/csv.h"

namespace knuckle {

std::string csvCell(const std::string& text)
{
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + '"';
}

std::vector<std::string> csvCells(std::string_view line)
{
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (size_t k = 0; k < line.size(); ++k) {
        if (line[k] == '"' && quoted && k + 1 < line.size() && line[k + 1] == '"') cells.back() += line[++k];
        else if (line[k] == '"') quoted = !quoted;
        else if (line[k] == ',' && !quoted) cells.emplace_back();
        else cells.back() += line[k];
    }
    return cells;
}

}  // namespace knuckle
