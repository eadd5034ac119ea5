#include "app/serve/web/page.h"

#include <map>
#include <string_view>

#include "app/report/markup.h"
#include "app/report/page_places.h"

namespace knuckle {

/// Made by cmake/embed.cmake of assets/serve.
const std::map<std::string, std::string_view>& embeddedServe();

std::string livePage(const std::string& name)
{
    return filledPage(embeddedServe().at("serve.html"), {{"title", escapedMarkup(name)},
                                                         {"style", std::string(embeddedServe().at("serve.css"))},
                                                         {"script", std::string(embeddedServe().at("serve.js"))}});
}

}  // namespace knuckle
