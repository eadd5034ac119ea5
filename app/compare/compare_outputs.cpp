#include "app/compare/compare_outputs.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/report/annotations.h"
#include "app/report/junit.h"
#include "app/report/report_page.h"
#include "app/run/tell.h"
#include "sim/base/files/endings.h"

namespace knuckle {

namespace {

/// A browser takes noticeably long to open what is larger.
constexpr double LARGE_MEGABYTES = 30.0;

}  // namespace

CompareOutputs::CompareOutputs(const CompareRun& run, RunPaths& paths)
    : run_(run), paths_(paths), list_(pictureBytesOf(run.reportMegabytes.value_or(DEFAULT_REPORT_MEGABYTES)))
{
    for (const std::string& input : run.otherInputs) paths.reads(input);
    if (!run.report.empty()) {
        requireEnding("--report ", run.report, "a report", {".html", ".htm"});
        paths.writes(run.report);
    }
    if (!run.junit.empty()) {
        requireEnding("--junit ", run.junit, "JUnit's XML", {".xml"});
        paths.writes(run.junit);
    }
}

void CompareOutputs::open()
{
    paths_.check();
    if (!run_.report.empty()) report_.emplace(run_.report);
    if (!run_.junit.empty()) junit_.emplace(run_.junit);
}

std::vector<ReportEntry> CompareOutputs::finish()
{
    std::vector<ReportEntry> entries = list_.take();
    if (report_) writePage(entries);
    if (junit_) {
        junit_->write(junitOf(fmt::format("knuckle compare {} {}", run_.first, run_.second), entries));
        junit_->commit();
    }
    if (run_.annotations) fmt::print("{}", githubAnnotations(entries));
    return entries;
}

void CompareOutputs::writePage(const std::vector<ReportEntry>& entries)
{
    const ReportHead head{
        fmt::format("{} and {}", run_.first, run_.second),
        {{"reference", run_.first}, {"output", run_.second}, {"made by", "knuckle " KNUCKLE_VERSION}}};
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
                             run_.report, run_.reportMegabytes.value_or(DEFAULT_REPORT_MEGABYTES)));
    else if (megabytes > LARGE_MEGABYTES)
        tellUser(fmt::format("{} has {:.0f} MB; --report-size keeps it smaller", run_.report, megabytes));
}

}  // namespace knuckle
