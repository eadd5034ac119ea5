#include "app/report/annotations.h"

#include <fmt/format.h>

#include "sim/rig/import/valid_text.h"

namespace knuckle {

namespace {

/// Valid UTF-8 in which nothing ends the message, or with `property`, the value of one.
std::string escaped(const std::string& text, bool property)
{
    std::string result;
    for (const char c : validText(text)) {
        if (c == '%') result += "%25";
        else if (c == '\r') result += "%0D";
        else if (c == '\n') result += "%0A";
        else if (property && c == ':') result += "%3A";
        else if (property && c == ',') result += "%2C";
        else result += c;
    }
    return result;
}

}  // namespace

std::string githubAnnotations(const std::vector<ReportEntry>& entries)
{
    std::string text;
    for (const ReportEntry& entry : entries) {
        if (!entry.failed()) continue;
        const std::string& path = entry.referencePath.empty() ? entry.outputPath : entry.referencePath;
        text += fmt::format("::error file={},title={}::{}\n", escaped(path, true), escaped(entry.name, true),
                            escaped(entry.line, false));
    }
    return text;
}

}  // namespace knuckle
