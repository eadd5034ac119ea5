#include "app/serve/changes/live_world.h"

#include "app/film/branch_run.h"

namespace knuckle {

LiveWorld::LiveWorld(Gpu& gpu, const Scene& scene, const Branch* branch)
    : scene_(scene), solver_(gpu, branch != nullptr ? branch->world(scene) : scene.world), fields_(scene.world)
{
    if (branch != nullptr) beginBranch(*branch, gpu, scene, solver_, nullptr);
    begin_ = solver_.saveState();
}

void LiveWorld::step()
{
    solver_.step();
    ++steps_;
}

void LiveWorld::apply(const Change& change)
{
    switch (change.kind) {
        case ChangeKind::Reset:
            solver_.loadState(begin_);
            fields_.reset();
            steps_ = 0;
            break;
        case ChangeKind::Set: fields_.set(solver_, change.name, change.value); break;
        case ChangeKind::Push:
        case ChangeKind::Throw:
        case ChangeKind::Stir:
        case ChangeKind::Release: applyChange(solver_, world(), change); break;
    }
}

}  // namespace knuckle
