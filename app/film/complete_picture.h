#pragma once

#include "app/scene/scene_file.h"

namespace knuckle {

/// Reads the picture that a scene has for its sky, if it has one, and takes colours of light from it.
/// @throws InputError, one line with the file and the JSON pointer, if it cannot be read, and as requireDrawable().
void completePicture(Scene& scene);

/// What a renderer would refuse later, without saying in which file.
/// @throws InputError, one line with the file and the JSON pointer.
void requireDrawable(const Scene& scene);

}  // namespace knuckle
