#include "app/serve/change.h"

#include <fmt/format.h>

#include <vector>

#include "app/scene/names/named.h"
#include "sim/base/errors.h"

namespace knuckle {

void applyChange(Solver& solver, const World& world, const Change& change)
{
    const std::vector<uint32_t> bodies = bodiesNamed(world, change.name);
    solver.edit([&](StateEdit& edit) {
        if (change.kind == ChangeKind::Release) {
            if (!edit.letGo(withHanging(world, bodies)))
                throw InputError(fmt::format("\"{}\" is held for ever; give it a `release` in the scene", change.name));
            return;
        }
        if (bodies.size() > 1) throw InputError(fmt::format("\"{}\" has several bodies; name one", change.name));
        if (!edit.responds(bodies[0]))
            throw InputError(fmt::format("\"{}\" is held or follows a clip; release it first", change.name));
        edit.push(bodies[0], change.impulse, change.at);
    });
}

}  // namespace knuckle
