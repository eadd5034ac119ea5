#include "app/serve/web/page.h"

#include <map>
#include <string_view>

#include "app/report/markup.h"

namespace knuckle {

/// Made by cmake/embed.cmake of assets/serve.
const std::map<std::string, std::string_view>& embeddedServe();

std::string livePage(const std::string& name)
{
    const std::map<std::string, std::string> values{{"{{title}}", escapedMarkup(name)},
                                                    {"{{style}}", std::string(embeddedServe().at("serve.css"))},
                                                    {"{{script}}", std::string(embeddedServe().at("serve.js"))}};
    std::string page(embeddedServe().at("serve.html"));
    for (const auto& [mark, value] : values)
        for (size_t at = page.find(mark); at != std::string::npos; at = page.find(mark, at + value.size()))
            page.replace(at, mark.size(), value);
    return page;
}

}  // namespace knuckle
