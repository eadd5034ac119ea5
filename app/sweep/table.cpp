#include "app/sweep/table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/export/csv.h"
#include "app/run/counted.h"
#include "app/run/tell.h"
#include "sim/base/errors.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

/// A value as a cell: a word without its quotes.
std::string cellOf(const Json& value)
{
    return value.is_string() ? value.get<std::string>() : value.dump();
}

/// How many numbers a field has in every run; 0: other values, which have one cell.
size_t componentsOf(const Sweep& sweep, size_t field)
{
    const Json& first = sweep.runs.front().values[field];
    const auto isAlike = [&](const SweepRun& run) {
        const Json& value = run.values[field];
        return value.is_array() && value.size() == first.size() &&
               std::ranges::all_of(value, [](const Json& part) { return part.is_number(); });
    };
    return std::ranges::all_of(sweep.runs, isAlike) ? first.size() : 0;
}

std::string componentName(const std::string& path, size_t component)
{
    return path + (path.starts_with('/') ? "/" : ".") + std::to_string(component);
}

void addResult(const SweepPlan& plan, const std::optional<RunResult>& result, std::vector<std::string>& row)
{
    row.push_back(result ? result->hash : "");
    for (const std::string& name : plan.measures)
        if (plan.simulates()) row.push_back(result ? cellOf(result->measures.value(name, Json(""))) : "");
    for (const std::string& name : plan.bodies)
        for (size_t k = 0; k < 3; ++k) {
            const Json centre = result ? result->bodies.value(name, Json()) : Json();
            row.push_back(centre.is_array() && k < centre.size() ? cellOf(centre[k]) : "");
        }
}

}  // namespace

size_t SweepTable::missing() const
{
    const auto isMissing = [](const std::optional<RunResult>& result) { return !result; };
    return static_cast<size_t>(std::ranges::count_if(results, isMissing));
}

std::set<std::string> SweepTable::devices() const
{
    std::set<std::string> names;
    for (const std::optional<RunResult>& result : results)
        if (result && !result->device.empty()) names.insert(result->device);
    return names;
}

std::string SweepTable::csv() const
{
    std::string text;
    const auto add = [&text](const std::vector<std::string>& cells) {
        for (size_t k = 0; k < cells.size(); ++k) text += (k == 0 ? "" : ",") + csvCell(cells[k]);
        text += '\n';
    };
    add(columns);
    for (const std::vector<std::string>& row : rows) add(row);
    return text;
}

SweepTable tableOf(const Sweep& sweep)
{
    const SweepPlan& plan = sweep.plan;
    SweepTable table;
    std::vector<size_t> components;
    table.columns.emplace_back("run");
    for (size_t field = 0; field < plan.fields.size(); ++field) {
        const std::string& path = plan.fields[field].path;
        components.push_back(componentsOf(sweep, field));
        if (components[field] == 0) table.columns.push_back(path);
        for (size_t k = 0; k < components[field]; ++k) table.columns.push_back(componentName(path, k));
    }
    if (!plan.simulates()) table.columns.emplace_back("frames");
    table.columns.emplace_back("hash");
    if (plan.simulates()) table.columns.insert(table.columns.end(), plan.measures.begin(), plan.measures.end());
    for (const std::string& name : plan.bodies)
        for (const char* axis : {"x", "y", "z"}) table.columns.push_back(name + " " + axis);
    for (const SweepRun& run : sweep.runs) {
        std::vector<std::string> row{std::to_string(run.number)};
        for (size_t field = 0; field < plan.fields.size(); ++field) {
            if (components[field] == 0) row.push_back(cellOf(run.values[field]));
            for (size_t k = 0; k < components[field]; ++k) row.push_back(cellOf(run.values[field][k]));
        }
        if (!plan.simulates()) row.push_back(run.frames);
        table.results.push_back(readResult(sweep.folderOf(run)));
        addResult(plan, table.results.back(), row);
        table.rows.push_back(std::move(row));
    }
    return table;
}

void collectSweep(const Sweep& sweep, const Watch& watch, bool quiet)
{
    sweep.requireRuns();
    const SweepTable table = tableOf(sweep);
    const std::string csv = sweep.folder + "/table.csv", page = sweep.folder + "/index.html";
    writeFile(csv, table.csv());
    writeFile(page, sweepPage(sweep, table));
    if (const std::set<std::string> devices = table.devices(); devices.size() > 1)
        tellUser(fmt::format("knuckle: warning: runs are of {} devices, which round differently: {}", devices.size(),
                             fmt::join(devices, ", ")));
    if (!quiet)
        fmt::print("{} of {}: {}, {}\n", sweep.runs.size() - table.missing(), counted(sweep.runs.size(), "run"), csv,
                   page);
    if (table.missing() == 0) return;
    size_t failed = 0;
    for (const SweepRun& run : sweep.runs) failed += sweep.folderOf(run).look(watch).stage == RunStage::Failed ? 1 : 0;
    throw RunError(fmt::format("{} of {} missing in {}, {} of them failed; `knuckle sweep status {}` says more",
                               table.missing(), counted(sweep.runs.size(), "run"), csv, failed, sweep.plan.path));
}

}  // namespace knuckle
