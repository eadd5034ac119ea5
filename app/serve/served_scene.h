#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/branch/branch.h"
#include "app/scene/scene_file.h"

namespace knuckle {

/// A scene, and what it goes on from.
struct ServedScene {
    Scene scene;
    std::unique_ptr<Branch> branch;  ///< Null: it begins at its start.
};

/// Reads a scene with changes on top of those of the command line, as `--set` takes them. @throws InputError.
using LoadServed = std::function<std::unique_ptr<ServedScene>(const std::vector<std::string>& sets)>;

}  // namespace knuckle
