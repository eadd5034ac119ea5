#pragma once

#include <gtest/gtest.h>

#include <string>

#include "app/scene/scene_file.h"
#include "sim/base/errors.h"
#include "tests/message_of.h"
#include "tests/places.h"
#include "tests/temp_folder.h"

namespace knuckle::test {

/// The world of a scene of one object; FILE stands for the project's figure.
inline World worldOf(std::string object, const std::string& more = "")
{
    const TempFolder folder;
    const size_t file = object.find("FILE");
    if (file != std::string::npos) object.replace(file, 4, inSource("assets/models/humanoid.glb"));
    return loadScene(folder.write("scene.json", "{" + more + R"("diameter": 0.05, "objects": [)" + object + "]}"), {})
        .world;
}

/// The error message for it, without the path of its file.
inline std::string complaintOf(const std::string& object, const std::string& more = "")
{
    const std::string message = messageOf<InputError>([&] { worldOf(object, more); });
    const size_t end = message.find("scene.json: ");
    return end == std::string::npos ? message : message.substr(end + 12);
}

}  // namespace knuckle::test
