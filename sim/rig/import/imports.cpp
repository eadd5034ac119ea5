#include "sim/rig/import/imports.h"

#include <algorithm>

namespace knuckle {

namespace {

/// Whether a model that was read with some options contains all that other options ask for.
bool serves(const ImportOptions& had, const ImportOptions& wanted)
{
    return had.fit == wanted.fit && had.pick == wanted.pick && had.clips >= wanted.clips &&
           had.surface >= wanted.surface;
}

}  // namespace

std::shared_ptr<const Model> Imports::read(const std::string& path, const ImportOptions& options)
{
    const auto found = std::ranges::find_if(
        models_, [&](const Entry& entry) { return entry.path == path && serves(entry.options, options); });
    if (found != models_.end()) return found->model;
    models_.push_back({path, options, std::make_shared<const Model>(importModel(path, options))});
    return models_.back().model;
}

}  // namespace knuckle
