#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "app/completion/command_facts.h"

namespace knuckle {

namespace {

/// The cases of a switch over the commands on the line.
struct Cases {
    std::string paths, kinds, values;
    std::set<std::string> valued;
};

/// @param path words of the command, without the program's.
void addCommand(Cases& cases, const CommandFacts& command, const std::string& path)
{
    std::vector<std::string> options, words;
    for (const OptionFacts& option : command.options) {
        options.insert(options.end(), option.names.begin(), option.names.end());
        if (option.value.empty()) continue;
        cases.valued.insert(option.names.begin(), option.names.end());
        if (option.words.empty()) continue;
        // The program's own may follow any command.
        std::vector<std::string> patterns;
        for (const std::string& name : option.names)
            patterns.push_back(path.empty() ? fmt::format("*' {}'", name) : fmt::format("'{} {}'", path, name));
        cases.values += fmt::format("        {}) words='{}' ;;\n", fmt::join(patterns, " | "),
                                    fmt::join(option.words, " "));
    }
    for (const CommandFacts& below : command.commands) words.push_back(below.name);
    for (const OptionFacts& positional : command.positionals)
        words.insert(words.end(), positional.words.begin(), positional.words.end());
    cases.kinds += fmt::format("        '{}') options+=' {}' words='{}' ;;\n", path, fmt::join(options, " "),
                               fmt::join(words, " "));
    for (const CommandFacts& below : command.commands) {
        const std::string longer = path.empty() ? below.name : path + " " + below.name;
        cases.paths += fmt::format("            '{} {}') path='{}' ;;\n", path, below.name, longer);
        addCommand(cases, below, longer);
    }
}

}  // namespace

std::string bashCompletion(const CommandFacts& program)
{
    Cases cases;
    addCommand(cases, program, "");
    std::vector<std::string> common;
    for (const OptionFacts& option : program.options)
        common.insert(common.end(), option.names.begin(), option.names.end());
    constexpr const char* SCRIPT = R"(# bash completion for {0}
_{0}()
{{
    local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}}
    local valued=' {1} ' options='{2}' path='' words='' word='' isValue='' k
    # Bash takes --option=value apart into three words.
    if [[ $current == '=' ]]; then
        current=''
    elif [[ $previous == '=' ]]; then
        previous=${{COMP_WORDS[COMP_CWORD-2]}}
    fi
    for ((k = 1; k < COMP_CWORD; k++)); do
        word=${{COMP_WORDS[k]}}
        if [[ $word == '=' ]]; then
            isValue=yes
            continue
        elif [[ $isValue ]]; then
            isValue=''
            continue
        elif [[ $valued == *" $word "* ]]; then
            isValue=yes
            continue
        fi
        case "$path $word" in
{3}        esac
    done
    if [[ $valued == *" $previous "* ]]; then
        case "$path $previous" in
{4}        esac
        COMPREPLY=($(compgen -W "$words" -- "$current"))
        return
    fi
    case "$path" in
{5}    esac
    [[ $current == -* ]] && words=$options
    COMPREPLY=($(compgen -W "$words" -- "$current"))
}}
# Where nothing else fits, files.
complete -o default -F _{0} {0}
)";
    return fmt::format(SCRIPT, program.name, fmt::join(cases.valued, " "), fmt::join(common, " "), cases.paths,
                       cases.values, cases.kinds);
}

}  // namespace knuckle
