#include "app/compare/report_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/report/annotations.h"
#include "app/report/junit.h"
#include "app/run/tell.h"
#include "sim/base/files/endings.h"

namespace knuckle {

namespace {

/// A browser takes noticeably long to open what is larger.
constexpr double LARGE_MEGABYTES = 30.0;

}  // namespace

ReportOutputs::ReportOutputs(ReportOptions options, RunPaths& paths)
    : options_(std::move(options)), list_(pictureBytesOf(options_.reportMegabytes.value_or(DEFAULT_REPORT_MEGABYTES)))
{
    if (!options_.report.empty()) {
        requireEnding("--report ", options_.report, "a report", {".html", ".htm"});
        paths.writes(options_.report);
    }
    if (!options_.junit.empty()) {
        requireEnding("--junit ", options_.junit, "JUnit's XML", {".xml"});
        paths.writes(options_.junit);
    }
}

void ReportOutputs::open()
{
    if (!options_.report.empty()) report_.emplace(options_.report);
    if (!options_.junit.empty()) junit_.emplace(options_.junit);
}

std::vector<ReportEntry> ReportOutputs::finish(const ReportHead& head, const std::string& suite)
{
    std::vector<ReportEntry> entries = list_.take();
    if (report_) writePage(head, entries);
    if (junit_) {
        junit_->write(junitOf(suite, entries));
        junit_->commit();
    }
    if (options_.annotations) fmt::print("{}", githubAnnotations(entries));
    return entries;
}

void ReportOutputs::writePage(const ReportHead& head, const std::vector<ReportEntry>& entries)
{
    writeReport(*report_, head, entries);
    report_->commit();
    size_t bytes = 0;
    bool leftOut = false;
    for (const ReportEntry& entry : entries) {
        bytes += entry.pictures.bytes();
        leftOut = leftOut || entry.leftOutBytes > 0;
    }
    const double megabytes = static_cast<double>(bytes) / static_cast<double>(pictureBytesOf(1.0));
    if (leftOut)
        tellUser(fmt::format("{} lacks pictures, of images that differ least: it would have more than {:g} MB; see "
                             "--report-size",
                             options_.report, options_.reportMegabytes.value_or(DEFAULT_REPORT_MEGABYTES)));
    else if (megabytes > LARGE_MEGABYTES)
        tellUser(fmt::format("{} has {:.0f} MB; --report-size keeps it smaller", options_.report, megabytes));
}

}  // namespace knuckle
