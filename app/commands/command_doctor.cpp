#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "app/commands/commands.h"
#include "app/doctor/driver_findings.h"
#include "app/doctor/findings_json.h"
#include "app/doctor/machine_findings.h"

namespace knuckle {

namespace {

void printLines(const Findings& findings, bool usable, bool quiet)
{
    for (const Finding& finding : findings)
        if (!quiet || finding.health == Health::Wrong) fmt::print("{}\n", lineOf(finding));
    const auto wrong = std::ranges::count(findings, Health::Wrong, &Finding::health);
    if (!usable) fmt::print("\nNothing can be simulated or drawn here.\n");
    else if (!quiet)
        fmt::print("\nknuckle {} can simulate and draw here{}.\n", KNUCKLE_VERSION,
                   wrong == 0 ? "" : fmt::format("; {} {} wrong", wrong, wrong == 1 ? "thing is" : "things are"));
}

int doctor(const CommonOptions& common, bool json)
{
    const DriverFindings driver = findDriver(common);
    Findings all = driver.findings;
    for (const Findings& more : {findMachine(driver.software), findFiles()})
        all.insert(all.end(), more.begin(), more.end());
    if (json) fmt::print("{}\n", findingsAsJson(all, driver, common.device));
    else printLines(all, driver.usable, common.quiet);
    return driver.usable ? EXIT_FINE : EXIT_DEVICE;
}

}  // namespace

void addDoctorCommand(CommandLine line)
{
    auto* command = line.program.add_subcommand("doctor",
                                                "Say what is missing or wrong on this machine, and what to do");
    command->fallthrough();
    command->footer("ok: works. note: good to know. WRONG: something does not work, then what to do. --quiet prints\n"
                    "only what is wrong. A driver or an ffmpeg that crashes or hangs is told as well.\n\n"
                    "Exit codes: 0 a device can be used, 3 none can, 2 no such device.\n\n"
                    "Examples:\n"
                    "  knuckle doctor\n"
                    "  knuckle doctor --device gpu     whether the GPU would do");
    auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "Print all findings as JSON, also with --quiet; docs/output.md");
    command->callback([=] { line.chosen = [=] { return doctor(line.common, *json); }; });
}

}  // namespace knuckle
