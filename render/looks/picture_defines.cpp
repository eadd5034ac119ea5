#include "render/looks/picture_defines.h"

namespace knuckle {

Defines curveDefines(const RenderSettings& settings)
{
    switch (settings.toneMap) {
        case ToneMap::Film: break;
        case ToneMap::Neutral: return {{"TONE_NEUTRAL", "1"}};
        case ToneMap::Agx: return {{"TONE_AGX", "1"}};
        case ToneMap::Linear: return {{"TONE_LINEAR", "1"}};
    }
    return {};
}

Defines displayDefines(const RenderSettings& settings)
{
    return joined({curveDefines(settings), hasLens(settings) ? Defines{{"LINEAR_LIGHT", "1"}} : Defines{},
                   settings.fog.density > 0.0f ? Defines{{"FOG", "1"}} : Defines{}});
}

Defines skyDefines(const RenderSettings& settings)
{
    return settings.light.sky != nullptr ? Defines{{"SKY_PICTURE", "1"}} : Defines{};
}

Defines joined(std::initializer_list<Defines> lists)
{
    Defines all;
    for (const Defines& list : lists) all.insert(all.end(), list.begin(), list.end());
    return all;
}

}  // namespace knuckle
