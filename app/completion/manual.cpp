#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "app/completion/command_facts.h"

namespace knuckle {

namespace {

/// Text of a page: signs of roff as themselves, and no line that reads as a request.
std::string roff(const std::string& text)
{
    std::string result;
    bool isStart = true;
    for (const char letter : text) {
        if (isStart && (letter == '.' || letter == '\'')) result += "\\&";
        if (letter == '\\') result += "\\e";
        else if (letter == '-') result += "\\-";
        else if (letter == '\'') result += "\\(aq";
        else if (letter == '`') result += "\\(ga";
        else if (letter == '^') result += "\\(ha";
        else if (letter == '~') result += "\\(ti";
        else result += letter;
        isStart = letter == '\n';
    }
    return result;
}

std::string capitals(std::string text)
{
    std::ranges::transform(text, text.begin(), [](unsigned char letter) { return std::toupper(letter); });
    return text;
}

/// A value's name, or the words that it may be.
std::string valueText(const OptionFacts& option)
{
    return option.words.empty() || option.value.find('|') != std::string::npos
               ? option.value
               : fmt::format("{}", fmt::join(option.words, "|"));
}

std::string entry(const OptionFacts& option)
{
    std::vector<std::string> names;
    for (const std::string& name : option.names) names.push_back("\\fB" + roff(name) + "\\fR");
    const std::string value = option.value.empty() ? "" : "\\fI" + roff(valueText(option)) + "\\fR";
    std::string text = fmt::format(".TP\n{}{}{}\n{}", fmt::join(names, ", "), names.empty() || value.empty() ? "" : " ",
                                   value, roff(option.description));
    if (!option.preset.empty()) text += roff(" [" + option.preset + "]");
    if (!option.range.empty()) text += roff(" (" + option.range + ")");
    return text + "\n";
}

std::string synopsis(const CommandFacts& command, const std::string& line)
{
    std::string text = ".B " + roff(line) + "\n[\\fIOPTIONS\\fR]";
    for (const OptionFacts& positional : command.positionals)
        text += fmt::format(" \\fI{}\\fR{}", roff(positional.value), positional.repeats ? " ..." : "");
    if (!command.commands.empty()) text += " \\fICOMMAND\\fR ...";
    return text + "\n";
}

/// Arguments, then options by their groups.
std::string entries(const CommandFacts& command, const char* heading)
{
    std::string text;
    std::vector<std::string> groups;
    if (!command.positionals.empty()) text += fmt::format("{} {}\n", heading, "ARGUMENTS");
    for (const OptionFacts& positional : command.positionals) text += entry(positional);
    for (const OptionFacts& option : command.options)
        if (std::ranges::count(groups, option.group) == 0) groups.push_back(option.group);
    for (const std::string& group : groups) {
        text += fmt::format("{} \"{}\"\n", heading, roff(capitals(group)));
        for (const OptionFacts& option : command.options)
            if (option.group == group) text += entry(option);
    }
    return text;
}

}  // namespace

std::string manualPage(const CommandFacts& program, const CommandFacts& command, const std::string& version)
{
    const bool isProgram = &program == &command;
    const std::string name = isProgram ? program.name : program.name + "-" + command.name;
    const std::string line = isProgram ? program.name : program.name + " " + command.name;
    std::string text = fmt::format(".TH \"{}\" 1 \"\" \"{} {}\" \"{}\"\n.SH NAME\n{} \\- {}\n", roff(capitals(name)),
                                   program.name, roff(version), "User Commands", roff(name), roff(command.description));
    text += ".SH SYNOPSIS\n" + synopsis(command, line) + entries(command, ".SH");
    if (!command.commands.empty()) text += ".SH COMMANDS\n";
    for (const CommandFacts& below : command.commands) {
        if (isProgram) {
            text += fmt::format(".TP\n.BR {}\\-{} (1)\n{}\n", roff(program.name), roff(below.name),
                                roff(below.description));
            continue;
        }
        text += fmt::format(".SS \"{}\"\n{}\n.PP\n{}", roff(line + " " + below.name), roff(below.description),
                            synopsis(below, line + " " + below.name));
        text += entries(below, ".SS");
    }
    if (!command.notes.empty()) text += ".SH NOTES\n.nf\n" + roff(command.notes) + "\n.fi\n";
    std::vector<std::string> others;
    if (!isProgram) others.push_back(fmt::format(".BR {} (1)", roff(program.name)));
    for (const CommandFacts& other : program.commands)
        if (other.name != command.name && !isProgram)
            others.push_back(fmt::format(".BR {}\\-{} (1)", roff(program.name), roff(other.name)));
    if (!others.empty()) text += fmt::format(".SH \"SEE ALSO\"\n{}\n", fmt::join(others, ",\n"));
    return text;
}

}  // namespace knuckle
