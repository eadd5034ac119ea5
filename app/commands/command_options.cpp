#include "app/commands/command_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "app/json/fields.h"
#include "render/output/film_kinds.h"
#include "render/output/frame_sink.h"
#include "sim/base/errors.h"

namespace knuckle {

CLI::Validator numberBetween(double lowest, double highest)
{
    const auto check = [=](std::string& text) -> std::string {
        char* end = nullptr;
        const double number = std::strtod(text.c_str(), &end);
        const auto value = text.empty() || *end != '\0' ? std::nullopt : std::optional(number);
        if (value && *value >= lowest && *value <= highest) return {};
        return fmt::format("{} is {}; give one from {:g} to {:g}", text,
                           value && std::isfinite(*value) ? "out of range" : "no finite number", lowest, highest);
    };
    return {check, fmt::format("FLOAT in [{:g} - {:g}]", lowest, highest)};
}

CLI::Validator oneOf(const std::vector<std::string>& words)
{
    CLI::Validator check = CLI::IsMember(words);
    return check.description("").name(fmt::format("{}{}", WORDS_PREFIX, fmt::join(words, " ")));
}

CLI::Validator offered(const std::vector<std::string>& words)
{
    return {[](std::string&) { return std::string(); }, "", fmt::format("{}{}", WORDS_PREFIX, fmt::join(words, " "))};
}

CLI::Validator offered(std::span<const char* const> words)
{
    return offered(std::vector<std::string>(words.begin(), words.end()));
}

std::vector<std::string> codecWords()
{
    std::vector<std::string> words;
    for (const char* ending : FILM_ENDINGS) {
        const FilmKind* kind = filmKindOf(std::string("film") + ending);
        if (kind == nullptr || !hasCodecs(*kind)) continue;
        for (const char* word : kind->codecs)
            if (std::ranges::count(words, word) == 0) words.emplace_back(word);
    }
    return words;
}

bool isQualityWord(const std::string& quality)
{
    return std::ranges::count(EnumWords<Quality>::WORDS, quality) > 0;
}

int jpegQuality(const std::string& quality)
{
    int number = DEFAULT_QUALITY;
    if (quality.empty() || isQualityWord(quality)) return number;
    const char* end = quality.data() + quality.size();
    const auto [last, error] = std::from_chars(quality.data(), end, number);
    if (error == std::errc() && last == end && number >= 1 && number <= 100) return number;
    throw InputError(
        fmt::format("--quality {}: must be draft, good or final, or for JPEG a number from 1 to 100", quality));
}

void refuseEmptyValues(const CLI::App& program)
{
    for (const CLI::App* command : program.get_subcommands()) refuseEmptyValues(*command);
    for (const CLI::Option* option : program.get_options())
        for (const std::string& value : option->results())
            if (value.empty() && option->get_expected_max() > 0)
                throw InputError(fmt::format("{}: its value is empty; give one, or leave it out",
                                             option->get_positional() ? option->get_name(true) : option->get_name()));
}

void addReportOptions(CLI::App& command, ReportOptions& options)
{
    const char* group = "Reports";
    command.add_option("--report", options.report, "Write a page of what differs, to look at in a browser")
        ->type_name("OUT.html")
        ->group(group);
    command.add_flag("--report-all", options.reportAll, "Equal images with their pictures, too")->group(group);
    command
        .add_option("--report-size", options.reportMegabytes,
                    fmt::format("Leave out pictures, of what differs least, beyond so many MB [{:g}]",
                                DEFAULT_REPORT_MEGABYTES))
        ->check(numberBetween(0, 2000).description(""))
        ->type_name("MB")
        ->group(group);
    command.add_option("--junit", options.junit, "Write a test case for each image, in JUnit's XML")
        ->type_name("OUT.xml")
        ->group(group);
    command
        .add_option_function<std::string>(
            "--annotations", [&options](const std::string&) { options.annotations = true; },
            "Print a line for each image that differs, as a service reads it")
        ->check(oneOf({"github"}))
        ->type_name("github")
        ->group(group);
}

void checkReportOptions(const ReportOptions& options, bool json)
{
    if (options.report.empty() && (options.reportAll || options.reportMegabytes))
        throw InputError("--report-all and --report-size are for --report; name its file, or leave them out");
    if (json && options.annotations)
        throw InputError("--json and --annotations both print to standard output; leave one of them out");
}

}  // namespace knuckle
