#pragma once

#include <string>
#include <vector>

#include "app/json/json.h"
#include "app/scene/overrides.h"
#include "sim/world/settings.h"

namespace knuckle {

/// A scene file completed by its schema.
struct SceneDocument {
    JsonFile file;
    Json given = {};             ///< The same with all changes, before that.
    bool givesDiameter = false;  ///< Whether the file gives the particles' size; else the schema's default is used.
};

/// Reads a scene file, applies changes, checks it and fills in every default.
/// @throws InputError, one line with the file and the JSON pointer of the fault.
SceneDocument readSceneDocument(const std::string& path, const std::vector<Override>& overrides);

/// The same for the text of SceneDocument::given.
SceneDocument storedSceneDocument(const std::string& path, const std::string& text);

/// The solver's settings from a preset's name and changes of its fields, as in a scene's `solver`.
/// @throws InputError as readSceneDocument(), and for a change of anything else.
Settings loadSettings(const std::string& preset, const std::vector<std::string>& changes);

}  // namespace knuckle
