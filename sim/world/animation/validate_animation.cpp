#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/base/errors.h"
#include "sim/world/animation/animation.h"
#include "sim/world/world.h"

namespace knuckle {

namespace {

void require(bool holds, const std::string& what)
{
    if (!holds) throw std::logic_error(what);
}

void validateClip(const BodyClip& clip)
{
    const auto name = [&] { return fmt::format("clip \"{}\": ", clip.name); };
    require(clip.rate > 0.0f && std::isfinite(clip.rate), name() + "its rate must be above 0");
    require(!clip.roots.empty() && clip.turns.size() == clip.roots.size() * clip.bodyCount,
            name() + "its keys have not one turn for each body");
    require(std::ranges::all_of(clip.roots, [](const Vector3f& p) { return p.allFinite(); }) &&
                std::ranges::all_of(clip.turns, [](const Quaternionf& q) { return std::abs(q.norm() - 1) < 1e-3f; }),
            name() + "its keys are not finite");
}

void validatePlays(const World& world, const Animation& animation)
{
    float last = 0.0f;
    for (const ClipPlay& play : animation.plays) {
        require(play.clip < world.clips.size(), "animation: it plays a clip that is not there");
        require(world.clips[play.clip].bodyCount == world.objects[animation.object].bodyCount,
                fmt::format("clip \"{}\" has other bodies than its object", world.clips[play.clip].name));
        require(play.at >= last && (play.start >= 0.0f || !play.loop) && play.speed >= 0.0f && play.fade >= 0.0f,
                "animation: its plays are not in order, or a time or speed of them is negative");
        last = play.at;
    }
}

}  // namespace

void validateAnimations(const World& world)
{
    for (const BodyClip& clip : world.clips) validateClip(clip);
    if (!world.animations.empty() && world.settings.solver != SolverKind::Impulse)
        throw InputError("the paper's solver has no animation; take `animation` away, or use solver method impulse");
    for (const Animation& animation : world.animations) {
        require(animation.object < world.objects.size(), "animation: there is no such object");
        require(!animation.plays.empty() && animation.plays.front().at == 0.0f, "animation: it plays nothing at first");
        validatePlays(world, animation);
        linksOf(world, animation);
    }
}

}  // namespace knuckle
