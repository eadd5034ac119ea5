#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/report/report_entry.h"
#include "render/reader/picture.h"

namespace knuckle::test {

/// Two pictures, compared and judged by the usual limits, with all pictures of a report.
ReportEntry madeEntry(const std::string& name, const Picture& reference, const Picture& output);
/// Missing where only a reference is, New where only an output is.
ReportEntry madeSingle(const std::string& name, const Picture& picture, ReportEntry::Status status);

/// A picture of 160 x 90 whose pixels are all different, and the same with a white box.
Picture madeScene();
Picture madeSceneWithBox(uint32_t left, uint32_t top, uint32_t width, uint32_t height);

/// Names that would break out of HTML, XML or annotations.
std::vector<std::string> oddNames();

/// What is wrong with the tags, attributes and entities of HTML or XML; empty where each tag is closed in order.
std::string markupProblem(std::string_view text, bool html);
size_t countOf(std::string_view text, std::string_view part);

}  // namespace knuckle::test
