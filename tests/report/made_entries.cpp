#include "tests/report/made_entries.h"

#include <algorithm>
#include <array>

#include "app/report/report_pictures.h"
#include "render/compare/difference_pictures.h"
#include "tests/compare/made_pictures.h"

namespace knuckle::test {

ReportEntry madeEntry(const std::string& name, const Picture& reference, const Picture& output)
{
    ReportEntry entry;
    entry.name = name;
    entry.referencePath = "golden/" + name;
    entry.outputPath = "out/" + name;
    entry.comparison = comparePictures(reference, output, {});
    entry.verdict = judge(entry.comparison, {});
    entry.status = entry.verdict.equal ? ReportEntry::Status::Equal : ReportEntry::Status::Different;
    entry.line = verdictLine(entry.comparison, entry.verdict);
    if (entry.verdict.equal) return entry;
    entry.pictures = {shownPng(reference), shownPng(output), "", ""};
    if (!entry.comparison.sameSize()) return entry;
    entry.pictures.difference = pngOf(differencePicture(reference, output, entry.comparison));
    entry.pictures.heatmap = pngOf(heatmapPicture(entry.comparison));
    return entry;
}

ReportEntry madeSingle(const std::string& name, const Picture& picture, ReportEntry::Status status)
{
    ReportEntry entry;
    entry.name = name;
    entry.status = status;
    const bool missing = status == ReportEntry::Status::Missing;
    entry.line = missing ? "missing in out" : "new, not in golden";
    (missing ? entry.referencePath : entry.outputPath) = name;
    (missing ? entry.pictures.reference : entry.pictures.output) = shownPng(picture);
    return entry;
}

Picture madeScene()
{
    return madePicture(160, 90, [](uint32_t x, uint32_t y) {
        return std::array{static_cast<int>(x), static_cast<int>(y * 2), static_cast<int>((x + y) % 64)};
    });
}

Picture madeSceneWithBox(uint32_t left, uint32_t top, uint32_t width, uint32_t height)
{
    Picture picture = madeScene();
    fillBox(picture, left, top, width, height, {255, 255, 255});
    return picture;
}

std::vector<std::string> oddNames()
{
    return {"<script>window.broken = true</script>.png",
            "\"><img src=x onerror=\"window.broken = true\">.png",
            "' onload='window.broken = true'.png",
            "</table></bdi><!-- .png",
            "{{rows}}&lt;&amp;.png",
            "two\nlines\tand\x01 bytes \xff\xfe.png",
            "]]>\xEF\xBF\xBF.png",
            "100 %, a: b::c.png"};
}

namespace {

constexpr std::array<std::string_view, 4> VOID_TAGS{"meta", "img", "br", "input"};

bool isKnownEntity(std::string_view text)
{
    const std::string_view name = text.substr(0, text.find(';'));
    if (name.size() > 8 || name.size() == text.size()) return false;
    if (name.starts_with("&#")) return name.find_first_not_of("0123456789", 2) == std::string_view::npos;
    constexpr std::array<std::string_view, 4> KNOWN{"&amp", "&lt", "&gt", "&quot"};
    return std::ranges::count(KNOWN, name) > 0;
}

/// Where a tag ends, quoted values skipped.
size_t endOfTag(std::string_view text, size_t i)
{
    char quote = 0;
    for (; i < text.size(); ++i) {
        if (quote != 0) quote = text[i] == quote ? 0 : quote;
        else if (text[i] == '"' || text[i] == '\'') quote = text[i];
        else if (text[i] == '>') return i;
    }
    return std::string_view::npos;
}

}  // namespace

std::string markupProblem(std::string_view text, bool html)
{
    std::vector<std::string> open;
    for (size_t i = 0; i < text.size(); ++i) {
        const auto problem = [&](const std::string& what) { return what + ": " + std::string(text.substr(i, 80)); };
        const auto byte = static_cast<uint8_t>(text[i]);
        if (byte < 0x20 && byte != '\n') return problem("a control character");
        if (text[i] == '&' && !isKnownEntity(text.substr(i))) return problem("no entity");
        if (text[i] != '<') continue;
        const size_t end = endOfTag(text, i);
        if (end == std::string_view::npos) return problem("a tag without an end");
        const bool closes = text[i + 1] == '/';
        const size_t start = i + (closes ? 2 : 1);
        const std::string name(text.substr(start, text.find_first_of(" />\n", start) - start));
        const bool empty = text[end - 1] == '/' || text[i + 1] == '!' || text[i + 1] == '?' ||
                           (html && std::ranges::count(VOID_TAGS, name) > 0);
        if (closes && (open.empty() || open.back() != name)) return problem("closed without being open");
        if (closes) open.pop_back();
        else if (!empty) open.push_back(name);
        i = end;
        if (html && !closes && (name == "script" || name == "style")) i = text.find("</" + name, i) - 1;
    }
    return open.empty() ? "" : "never closed: " + open.back();
}

size_t countOf(std::string_view text, std::string_view part)
{
    size_t count = 0;
    for (size_t i = text.find(part); i != std::string_view::npos; i = text.find(part, i + 1)) ++count;
    return count;
}

}  // namespace knuckle::test
