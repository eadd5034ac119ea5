#pragma once

#include <gtest/gtest.h>

#include <string>

#include "sim/base/errors.h"
#include "sim/rig/import/import.h"
#include "tests/message_of.h"
#include "tests/rig/import/edited_glb.h"
#include "tests/temp_folder.h"

namespace knuckle::test {

/// Imports changed glTF files with their surfaces, or returns why they are refused.
class SurfaceImport : public testing::Test {
protected:
    Model import(EditedGlb& glb) const
    {
        ImportOptions options;
        options.surface = true;
        return importModel(folder_.write("small.glb", glb.bytes()), options);
    }
    std::string refusal(EditedGlb& glb) const
    {
        return messageOf<InputError>([&] { import(glb); });
    }
    TempFolder folder_;
};

}  // namespace knuckle::test
