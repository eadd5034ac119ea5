#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/completion/command_facts.h"
#include "app/json/json.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

std::vector<std::string> commandNames(const CommandFacts& program)
{
    std::vector<std::string> names;
    for (const CommandFacts& command : program.commands) names.push_back(command.name);
    return names;
}

void printManual(const CommandFacts& program, const std::string& name)
{
    const auto found = std::ranges::find(program.commands, name, &CommandFacts::name);
    if (!name.empty() && found == program.commands.end())
        throw InputError(fmt::format("man {}: is no command; {}", name, suggestion(name, commandNames(program))));
    fmt::print("{}", manualPage(program, name.empty() ? program : *found, KNUCKLE_VERSION));
}

}  // namespace

void addCompletionCommand(CommandLine line)
{
    auto* command = line.program.add_subcommand("completion", "Print what completes command lines in a shell");
    command->fallthrough();
    command->footer("cmake --install puts them where shells look. Without it:\n"
                    "  source <(knuckle completion bash)                                        in ~/.bashrc\n"
                    "  knuckle completion zsh > ~/.zfunc/_knuckle                               a folder of $fpath\n"
                    "  knuckle completion fish > ~/.config/fish/completions/knuckle.fish");
    auto shell = std::make_shared<std::string>();
    command->add_option("SHELL", *shell, "bash, zsh or fish")->required()->check(oneOf({"bash", "zsh", "fish"}));
    command->callback([=] {
        line.chosen = [=] {
            const CommandFacts program = factsOf(line.program);
            fmt::print("{}", *shell == "bash"  ? bashCompletion(program)
                             : *shell == "zsh" ? zshCompletion(program)
                                               : fishCompletion(program));
            return EXIT_FINE;
        };
    });
}

void addManualCommand(CommandLine line)
{
    auto* command = line.program.add_subcommand("man", "Print a page of the manual, of the program or of a command");
    command->fallthrough();
    command->footer("cmake --install puts them where man looks.\n\n"
                    "Examples:\n"
                    "  knuckle man render | man -l -\n"
                    "  knuckle man --list              the commands that have a page");
    auto name = std::make_shared<std::string>();
    auto list = std::make_shared<bool>(false);
    std::vector<std::string> names;
    for (const CLI::App* other : line.program.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(other->get_name());
    command->add_option("COMMAND", *name, "Of which command [the program]")->check(offered(names));
    command->add_flag("--list", *list, "Print the names of all commands instead");
    command->callback([=] {
        line.chosen = [=] {
            const CommandFacts program = factsOf(line.program);
            if (*list) fmt::print("{}\n", fmt::join(commandNames(program), "\n"));
            else printManual(program, *name);
            return EXIT_FINE;
        };
    });
}

}  // namespace knuckle
