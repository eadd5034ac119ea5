#include "app/doctor/finding.h"

#include <algorithm>

namespace knuckle {

std::string lineOf(const Finding& finding)
{
    constexpr const char* WORDS[] = {"ok     ", "note   ", "WRONG  "};
    std::string line = WORDS[static_cast<int>(finding.health)] + finding.what;
    if (!finding.remedy.empty()) line += "; " + finding.remedy;
    std::ranges::replace(line, '\n', ' ');
    return line;
}

}  // namespace knuckle
