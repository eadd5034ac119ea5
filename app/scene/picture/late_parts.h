#pragma once

#include <string>
#include <vector>

#include "render/settings.h"

namespace knuckle {

/// Shots and captions that begin when a film of `duration` seconds is over: a sentence for each.
std::vector<std::string> lateParts(const RenderSettings& render, double duration);

}  // namespace knuckle
