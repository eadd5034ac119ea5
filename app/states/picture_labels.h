#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "app/states/states_file.h"
#include "render/picture/image.h"

namespace knuckle {

/// What a frame's PNG says of where it comes from, as text chunks: `Software`, and `knuckle:` with scene, frame, state
/// (its hash), driver, device, ... (docs/states.md).
PngText labelsOf(const RunFacts& facts, uint64_t frame, uint64_t stateHash);
/// The same for `knuckle info FRAME.png`, a line each. @param text of a PNG, by keyword. Empty: it says nothing.
std::string labelLines(const std::map<std::string, std::string>& text);
/// What two frames say of why they may differ: other drivers, programs or states; or that the state is the same, so
/// that what was drawn differs. Empty if they say nothing.
std::string originsLine(const std::map<std::string, std::string>& first,
                        const std::map<std::string, std::string>& second);

}  // namespace knuckle
