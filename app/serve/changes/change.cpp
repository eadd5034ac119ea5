#include "app/serve/changes/change.h"

#include <fmt/format.h>

#include <optional>
#include <vector>

#include "app/scene/names/named.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

void stir(StateEdit& edit, const World& world, const Change& change)
{
    const std::optional<Named> what = looseNamed(world, change.name);
    if (!what) throw InputError(fmt::format("\"{}\" has no particles without bodies", change.name));
    if (!edit.stir(what->first, what->end, change.impulse, change.at, change.radius))
        throw InputError(fmt::format("nothing of \"{}\" that may move is there", change.name));
}

void letGo(StateEdit& edit, const World& world, const Change& change)
{
    if (!edit.letGo(withHanging(world, bodiesNamed(world, change.name))))
        throw InputError(fmt::format("\"{}\" is held for ever; give it a `release` in the scene", change.name));
}

/// A body's first throw lets go of it, too.
void throwFrom(StateEdit& edit, const World& world, const Change& change)
{
    const std::vector<uint32_t> bodies = bodiesNamed(world, change.name);
    if (bodies.size() > 1 || !edit.freeNow(bodies[0]))
        throw InputError(fmt::format("\"{}\" cannot be thrown from elsewhere", change.name));
    edit.move(bodies, Eigen::Isometry3f(Eigen::Translation3f(change.at) * edit.pose(bodies[0]).inverse()));
    edit.setVelocity(bodies, {change.velocity, {0, 0, 0}, change.at});
}

void push(StateEdit& edit, const World& world, const Change& change)
{
    const std::vector<uint32_t> bodies = bodiesNamed(world, change.name);
    if (bodies.size() > 1) throw InputError(fmt::format("\"{}\" has several bodies; name one", change.name));
    if (!edit.responds(bodies[0]))
        throw InputError(fmt::format("\"{}\" is held or follows a clip; release it first", change.name));
    edit.push(bodies[0], change.impulse, change.at);
}

}  // namespace

void applyChange(Solver& solver, const World& world, const Change& change)
{
    solver.edit([&](StateEdit& edit) {
        if (change.kind == ChangeKind::Stir) stir(edit, world, change);
        else if (change.kind == ChangeKind::Throw) throwFrom(edit, world, change);
        else if (change.kind == ChangeKind::Release) letGo(edit, world, change);
        else push(edit, world, change);
    });
}

}  // namespace knuckle
