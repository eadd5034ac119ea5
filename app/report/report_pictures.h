#pragma once

#include "app/report/report_entry.h"
#include "render/reader/picture.h"

namespace knuckle {

/// A picture as an 8-bit PNG file, with alpha where it has some. What is beyond 0 and 1 is cut off.
std::string shownPng(const Picture& picture);

/// Fills in the pictures of an entry that was not compared, from the files that it has. What cannot be read is left
/// out, and `problem` noted where nothing has told it yet.
void readPictures(ReportEntry& entry);

}  // namespace knuckle
