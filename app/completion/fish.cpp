#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/completion/command_facts.h"

namespace knuckle {

namespace {

std::string quoted(const std::string& text)
{
    std::string result = "'";
    for (const char letter : text) {
        if (letter == '\'' || letter == '\\') result += '\\';
        result += letter;
    }
    return result + "'";
}

/// @param start of each line, with the program and the condition.
void addOption(std::string& text, const std::string& start, const OptionFacts& option)
{
    text += start;
    for (const std::string& name : option.names)
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    if (!option.value.empty())
        text += option.words.empty() ? " -r -F" : fmt::format(" -x -a '{}'", fmt::join(option.words, " "));
    text += " -d " + quoted(option.description) + "\n";
}

/// @param condition under which the line is this command's.
void addCommand(std::string& text, const CommandFacts& command, const std::string& program,
                const std::string& condition)
{
    const std::string start = fmt::format("complete -c {}{}", program,
                                          condition.empty() ? "" : fmt::format(" -n '{}'", condition));
    for (const OptionFacts& option : command.options) addOption(text, start, option);
    for (const OptionFacts& positional : command.positionals) {
        if (!positional.words.empty()) text += fmt::format("{} -f -a '{}'\n", start, fmt::join(positional.words, " "));
        else if (!command.commands.empty()) text += start + " -F\n";  // files all the same, beside commands
    }
    std::vector<std::string> names;
    for (const CommandFacts& below : command.commands) names.push_back(below.name);
    for (const CommandFacts& below : command.commands) {
        const std::string before = condition.empty() ? "" : condition + "; and ";
        const std::string none = fmt::format("{}not __fish_seen_subcommand_from {}", before, fmt::join(names, " "));
        text += fmt::format("complete -c {} -n '{}' -f -a {} -d {}\n", program, none, below.name,
                            quoted(below.description));
        addCommand(text, below, program, fmt::format("{}__fish_seen_subcommand_from {}", before, below.name));
    }
}

}  // namespace

std::string fishCompletion(const CommandFacts& program)
{
    std::string text = fmt::format("# fish completion for {}\n", program.name);
    addCommand(text, program, program.name, "");
    return text;
}

}  // namespace knuckle
