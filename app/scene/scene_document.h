#pragma once

#include <string>
#include <vector>

#include "app/json/json.h"
#include "app/scene/overrides.h"
#include "sim/world/settings.h"

namespace knuckle {

/// A scene file as its schema completes it.
struct SceneDocument {
    JsonFile file;
    bool givesDiameter = false;  ///< Whether the file says how large particles are; else the schema's default stands.
};

/// Reads a scene file, changes what somebody wants to be changed, checks it and fills in every default.
/// @throws InputError, one line with the file and the JSON pointer of what is wrong.
SceneDocument readSceneDocument(const std::string& path, const std::vector<Override>& overrides);

/// The solver's settings by a preset's name and changes of its fields, as a scene's `solver` would give them.
/// @throws InputError as readSceneDocument(), and for a change of anything else.
Settings loadSettings(const std::string& preset, const std::vector<std::string>& changes);

}  // namespace knuckle
