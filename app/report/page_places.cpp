#include "app/report/page_places.h"

#include <stdexcept>

namespace knuckle {

void fillPage(std::string_view page, const std::map<std::string_view, std::function<void()>>& values,
              const std::function<void(std::string_view)>& write)
{
    for (size_t open = page.find("{{"); open != std::string_view::npos; open = page.find("{{")) {
        const size_t close = page.find("}}", open);
        write(page.substr(0, open));
        const auto value = values.find(page.substr(open + 2, close - open - 2));
        if (close == std::string_view::npos || value == values.end())
            throw std::logic_error("a page has an unknown place");
        value->second();
        page.remove_prefix(close + 2);
    }
    write(page);
}

std::string filledPage(std::string_view page, const std::map<std::string_view, std::string>& values)
{
    std::string filled;
    std::map<std::string_view, std::function<void()>> places;
    for (const auto& [name, value] : values) places[name] = [&filled, &text = value] { filled += text; };
    fillPage(page, places, [&filled](std::string_view part) { filled += part; });
    return filled;
}

}  // namespace knuckle
