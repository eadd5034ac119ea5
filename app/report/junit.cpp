#include "app/report/junit.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/report/markup.h"

namespace knuckle {

namespace {

using Status = ReportEntry::Status;

std::string propertiesOf(const ReportEntry& entry)
{
    std::vector<ReportNote> notes{{"status", entry.statusWord()}};
    if (!entry.referencePath.empty()) notes.emplace_back("reference", entry.referencePath);
    if (!entry.outputPath.empty()) notes.emplace_back("output", entry.outputPath);
    if (entry.status == Status::Different || entry.status == Status::Equal)
        for (ReportNote& figure : figuresOf(entry.comparison)) notes.push_back(std::move(figure));
    notes.insert(notes.end(), entry.notes.begin(), entry.notes.end());
    std::string text = "      <properties>\n";
    for (const auto& [name, value] : notes)
        text += fmt::format("        <property name=\"{}\" value=\"{}\"/>\n", escapedMarkup(name),
                            escapedMarkup(value));
    return text + "      </properties>\n";
}

std::string caseOf(const std::string& suite, const ReportEntry& entry)
{
    std::string text = fmt::format("    <testcase classname=\"{}\" name=\"{}\">\n", suite, escapedMarkup(entry.name)) +
                       propertiesOf(entry);
    if (entry.failed())
        text += fmt::format("      <{0} type=\"{1}\" message=\"{2}\">{2}</{0}>\n",
                            entry.status == Status::Unreadable ? "error" : "failure", entry.statusWord(),
                            escapedMarkup(entry.line));
    return text + "    </testcase>\n";
}

}  // namespace

std::string junitOf(const std::string& suite, const std::vector<ReportEntry>& entries)
{
    const auto errors = std::ranges::count_if(
        entries, [](const ReportEntry& entry) { return entry.status == Status::Unreadable; });
    const auto failed = std::ranges::count_if(entries, [](const ReportEntry& entry) { return entry.failed(); });
    const std::string counts = fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\"", entries.size(),
                                           failed - errors, errors);
    const std::string name = escapedMarkup(suite);
    std::string text = fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {0}>\n"
                                   "  <testsuite name=\"{1}\" {0} skipped=\"0\">\n",
                                   counts, name);
    for (const ReportEntry& entry : entries) text += caseOf(name, entry);
    return text + "  </testsuite>\n</testsuites>\n";
}

}  // namespace knuckle
