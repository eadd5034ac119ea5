#include "app/scene/picture/late_parts.h"

#include <fmt/format.h>

namespace knuckle {

std::vector<std::string> lateParts(const RenderSettings& render, double duration)
{
    std::vector<std::string> told;
    const auto tell = [&](const char* list, size_t index, double from) {
        if (from >= duration)
            told.push_back(fmt::format("/{}/{}/from is {:g} s, when the film of {:g} s is over: it is not seen.", list,
                                       index, from, duration));
    };
    for (size_t i = 0; i < render.shots.size(); ++i) tell("shots", i, render.shots[i].from);
    const std::vector<Caption>& captions = render.overlay.captions;
    for (size_t i = 0; i < captions.size(); ++i) tell("captions", i, double{captions[i].from});
    return told;
}

}  // namespace knuckle
