#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/completion/command_facts.h"

namespace knuckle {

namespace {

/// Between single quotes, in a specification of _arguments, whose own signs get a backslash.
std::string quoted(const std::string& text)
{
    std::string result;
    for (const char letter : text) {
        if (letter == '\'') result += "'\\''";
        else
            result += std::string(":[]\\").find(letter) != std::string::npos ? std::string("\\") + letter
                                                                             : std::string(1, letter);
    }
    return result;
}

std::string valueOf(const OptionFacts& option)
{
    const std::string action = option.words.empty() ? "_files" : fmt::format("({})", fmt::join(option.words, " "));
    return fmt::format(":{}:{}", quoted(option.value), action);
}

/// What stands in place of a command (a plan, beside `sweep status`), in its case.
std::string insteadOf(const OptionFacts& option)
{
    return option.words.empty() ? "      _files\n" : fmt::format("      compadd {}\n", fmt::join(option.words, " "));
}

void addOption(std::string& text, const OptionFacts& option)
{
    const std::string many = option.repeats ? "'*'" : "";
    const std::string names = option.names.size() == 1 ? option.names[0]
                                                       : fmt::format("{{{}}}", fmt::join(option.names, ","));
    text += fmt::format("    {}{}'[{}]{}'\n", many, names, quoted(option.description),
                        option.value.empty() ? "" : valueOf(option));
}

/// @param name of the function. @param common the program's options.
void addFunction(std::string& text, const CommandFacts& command, const std::string& name,
                 const std::vector<OptionFacts>& common)
{
    std::string body = fmt::format("{}() {{\n  local curcontext=$curcontext state line\n  local -a options=(\n", name);
    for (const OptionFacts& option : command.options) addOption(body, option);
    for (const OptionFacts& option : common) addOption(body, option);
    body += "  )\n  _arguments -C $options";
    if (command.commands.empty()) {
        for (const OptionFacts& positional : command.positionals)
            body += fmt::format(" \\\n    '{}{}'", positional.repeats ? "*" : "", valueOf(positional));
        text += body + "\n}\n\n";
        return;
    }
    body += " \\\n    '1:command:->command' '*::argument:->argument' && return 0\n  case $state in\n"
            "    command)\n      local -a commands=(\n";
    for (const CommandFacts& below : command.commands)
        body += fmt::format("        '{}:{}'\n", below.name, quoted(below.description));
    body += "      )\n      _describe command commands\n";
    for (const OptionFacts& positional : command.positionals) body += insteadOf(positional);
    body += "      ;;\n    argument)\n      case $words[1] in\n";
    for (const CommandFacts& below : command.commands)
        body += fmt::format("        {0}) {1}_{0} ;;\n", below.name, name);
    if (!command.positionals.empty()) body += "        *) _arguments $options ;;\n";
    text += body + "      esac\n      ;;\n  esac\n}\n\n";
    std::vector<OptionFacts> inherited = common.empty() ? command.options : common;
    std::erase_if(inherited, [](const OptionFacts& option) {
        return option.names.back() == "--help" || option.names.back() == "--version";
    });
    for (const CommandFacts& below : command.commands) addFunction(text, below, name + "_" + below.name, inherited);
}

}  // namespace

std::string zshCompletion(const CommandFacts& program)
{
    std::string text = fmt::format("#compdef {0}\n# zsh completion for {0}\n\n", program.name);
    addFunction(text, program, "_" + program.name, {});
    return text + fmt::format("_{} \"$@\"\n", program.name);
}

}  // namespace knuckle
