#pragma once

#include "app/scene/scene_file.h"

namespace knuckle {

/// Reads the picture that a scene has for its sky, if it has one, takes colours of light from it, and requires all that
/// a renderer would refuse later, without saying in which file.
/// @throws InputError, one line with the file and the JSON pointer.
void completePicture(Scene& scene);

}  // namespace knuckle
