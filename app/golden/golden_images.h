#pragma once

#include "app/golden/golden_check.h"

namespace knuckle {

/// Compares the pictures of another program, which a command makes anew. @throws InputError where it fails.
CheckedGolden checkImages(const Golden& golden, const CheckOptions& options);

/// Runs the golden's command, if it has one, in its folder.
/// @throws InputError if it fails, or leaves an image of before as it was.
void makeImages(const Golden& golden);

/// @throws InputError for an image that is the file with which it would be compared.
void requireOwnReferences(const Golden& golden, const std::string& key);

}  // namespace knuckle
