#pragma once

#include <string>
#include <vector>

namespace knuckle {

/// An option or a positional argument, as a manual page and completions need it.
struct OptionFacts {
    std::vector<std::string> names;  ///< "-o", "--output"; of a positional argument none.
    std::string value;               ///< What its value is called; empty: it has none.
    std::string range;               ///< Of numbers, for people.
    std::string description, group;
    std::string preset;              ///< Its value unless given, empty if the description has it.
    std::vector<std::string> words;  ///< Of which the value may be one; none: it is a file, or anything else.
    bool repeats = false;
};

struct CommandFacts {
    std::string name, description;
    std::string notes;  ///< What follows the options.
    std::vector<OptionFacts> options = {}, positionals = {};
    std::vector<CommandFacts> commands = {};
};

/// Scripts that complete command lines.
std::string bashCompletion(const CommandFacts& program);
std::string zshCompletion(const CommandFacts& program);
std::string fishCompletion(const CommandFacts& program);

/// A page for man. @param command of the program, or the program itself.
std::string manualPage(const CommandFacts& program, const CommandFacts& command, const std::string& version);

}  // namespace knuckle
