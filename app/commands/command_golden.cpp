#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/golden/golden_commands.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

constexpr const char* GOLDEN_NOTES =
    "A golden is a folder with golden.json, reference pictures, and the states that they were drawn from. A check "
    "first "
    "simulates and compares states, then draws from the stored states and compares pictures, so that a change of "
    "physics and a change of drawing fail apart.\n\n"
    "Exit codes: 0 as it was, 4 different, 2 what cannot be read or checked.\n\n"
    "Examples:\n"
    "  knuckle golden add assets/scenes/hello.json                     in golden/hello\n"
    "  knuckle golden add out/logo.png --command 'make logo'           pictures of another program\n"
    "  knuckle golden check                                            all in golden\n"
    "  knuckle golden check tests/golden 'water/*' --report report.html\n"
    "  knuckle golden update tests/golden hello                        accepts what has changed\n"
    "  knuckle golden suggest tests/golden                             limits from what drivers differ by\n\n"
    "docs/golden.md has more, and examples for GitHub and GitLab.";

constexpr const char* CHOICE = "The folder of the goldens [golden], then names or patterns of some of them [all]";

/// --states and --pictures.
struct Parts {
    bool states = false, pictures = false;

    void apply(bool& withStates, bool& withPictures) const
    {
        if (states && pictures)
            throw InputError("--states and --pictures leave nothing out together; leave out one, or both");
        withStates = !pictures;
        withPictures = !states;
    }
};

void addParts(CLI::App& command, Parts& parts)
{
    command.add_flag("--states", parts.states, "Only simulate and compare states");
    command.add_flag("--pictures", parts.pictures, "Only draw stored states and compare pictures");
}

struct CheckWords {
    std::vector<std::string> words, sets;
    CheckOptions options;
    Parts parts;
    bool json = false;
};

void addCheck(CLI::App& golden, CommandLine line)
{
    auto* command = golden.add_subcommand("check", "Compare with the references; exit code 4 when anything differs");
    command->fallthrough();
    auto words = std::make_shared<CheckWords>();
    command->add_option("DIR", words->words, CHOICE);
    addParts(*command, words->parts);
    command->add_option("--until", words->options.until, "Leave out later frames")
        ->type_name("FRAME")
        ->check(numberBetween(1, 1e6).description(""));
    command->add_option("--set", words->sets, "Change a field of all scenes, to try what a check sees")
        ->type_name("PATH=VALUE")
        ->take_all()
        ->allow_extra_args(false);
    addReportOptions(*command, words->options.reports);
    command->add_flag("--json", words->json, "Print all figures as JSON, also with --quiet");
    command->callback([=] {
        line.chosen = [=] {
            CheckOptions options = words->options;
            checkReportOptions(options.reports, words->json);
            words->parts.apply(options.states, options.pictures);
            for (const std::string& text : words->sets) options.changes.push_back(parseOverride(text));
            return checkGoldens(GoldenChoice::parse(words->words), options, words->json, line.common);
        };
    });
}

void addUpdate(CLI::App& golden, CommandLine line)
{
    auto* command = golden.add_subcommand("update", "Accept what has changed: write references that failed anew");
    command->fallthrough();
    auto words = std::make_shared<std::vector<std::string>>();
    auto options = std::make_shared<UpdateOptions>();
    auto other = std::make_shared<std::string>();
    auto parts = std::make_shared<Parts>();
    command->add_option("DIR", *words, CHOICE);
    command->add_flag("--all", options->all, "Also what has not failed");
    addParts(*command, *parts);
    command
        ->add_option("--other-driver", *other,
                     "Where references are of another driver than this: add some beside them, or replace them")
        ->type_name("beside|replace")
        ->check(oneOf({"beside", "replace"}));
    command->callback([=] {
        line.chosen = [=] {
            parts->apply(options->states, options->pictures);
            if (!other->empty()) options->otherDriver = *other == "beside" ? OtherDriver::Beside : OtherDriver::Replace;
            return updateGoldens(GoldenChoice::parse(*words), *options, line.common);
        };
    });
}

void addAdd(CLI::App& golden, CommandLine line)
{
    auto* command = golden.add_subcommand("add", "Make a golden of a scene, or of pictures of another program");
    command->fallthrough();
    auto options = std::make_shared<AddOptions>();
    command->add_option("INPUT", options->inputs, "A scene file, or images")->required();
    command->add_option("--in", options->folder, "The folder of the goldens")->type_name("DIR")->capture_default_str();
    command->add_option("--name", options->name, "Its name [that of the first input]")->type_name("NAME");
    command->add_option("--frames", options->frames, "Frames of the scene, also as first, middle, last")
        ->type_name("LIST")
        ->capture_default_str();
    command->add_option("--size", options->size, "Pixels of the scene's pictures [480x270]")->type_name("WxH");
    command->add_option("--set", options->sets, "Change a field of the scene")
        ->type_name("PATH=VALUE")
        ->take_all()
        ->allow_extra_args(false);
    command->add_option("--command", options->command, "A line for the shell that makes the images anew, here")
        ->type_name("LINE");
    command->callback([=] { line.chosen = [=] { return addGolden(*options, line.common); }; });
}

void addSuggest(CLI::App& golden, CommandLine line)
{
    auto* command = golden.add_subcommand(
        "suggest", "Propose limits from repeats, thread counts, widths of vectors and drivers that are here");
    command->fallthrough();
    auto words = std::make_shared<std::vector<std::string>>();
    auto options = std::make_shared<SuggestOptions>();
    command->add_option("DIR", *words, CHOICE);
    command->add_option("--repeats", options->repeats, "How often each device checks as it is")
        ->type_name("N")
        ->check(numberBetween(1, 1000).description(""))
        ->capture_default_str();
    command->add_flag("--write", options->write, "Put them into golden.json");
    command->callback(
        [=] { line.chosen = [=] { return suggestLimits(GoldenChoice::parse(*words), *options, line.common); }; });
}

}  // namespace

void addGoldenCommand(CommandLine line)
{
    auto* command = line.program.add_subcommand("golden", "Golden images: check, update, add, suggest");
    command->fallthrough();
    command->require_subcommand(1);
    command->footer(GOLDEN_NOTES);
    addCheck(*command, line);
    addUpdate(*command, line);
    addAdd(*command, line);
    addSuggest(*command, line);
}

}  // namespace knuckle
