#include "app/completion/command_facts.h"

#include <CLI/CLI.hpp>
#include <string_view>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"

namespace knuckle {

namespace {

std::vector<CLI::Validator*> validatorsOf(CLI::Option& option)
{
    std::vector<CLI::Validator*> all;
    try {
        for (int k = 0;; ++k) all.push_back(option.get_validator(k));
    } catch (const CLI::OptionNotFound&) {
        return all;  // there is no other way to count them
    }
}

std::vector<std::string> wordsIn(std::string_view list, char between)
{
    std::vector<std::string> words;
    while (!list.empty()) {
        const size_t end = std::min(list.find(between), list.size());
        words.emplace_back(list.substr(0, end));
        list.remove_prefix(std::min(end + 1, list.size()));
    }
    return words;
}

OptionFacts factsOf(CLI::Option& option)
{
    OptionFacts facts;
    facts.description = option.get_description();
    facts.group = option.get_group();
    facts.repeats = option.get_items_expected_max() > 1 ||
                    option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
    if (!option.nonpositional()) facts.names.clear();
    else {
        for (const std::string& name : option.get_snames()) facts.names.push_back("-" + name);
        for (const std::string& name : option.get_lnames()) facts.names.push_back("--" + name);
    }
    if (option.get_expected_max() == 0) return facts;
    facts.preset = option.get_default_str();
    const std::string type = option.get_type_name();
    const size_t colon = type.find(':');
    facts.value = option.nonpositional() ? type.substr(0, colon) : option.get_name(true);
    for (CLI::Validator* validator : validatorsOf(option)) {
        const std::string name = validator->get_name(), text = validator->get_description();
        if (name.starts_with(WORDS_PREFIX))
            facts.words = wordsIn(std::string_view(name).substr(std::string_view(WORDS_PREFIX).size()), ' ');
        else if (text.starts_with('{') && text.ends_with('}'))
            facts.words = wordsIn(std::string_view(text).substr(1, text.size() - 2), ',');
        else if (!text.empty()) facts.range = text;
    }
    return facts;
}

}  // namespace

CommandFacts factsOf(CLI::App& command)
{
    CommandFacts facts{command.get_name(), command.get_description(), command.get_footer()};
    while (facts.notes.ends_with('\n')) facts.notes.pop_back();
    for (CLI::Option* option : command.get_options(nullptr))
        (option->nonpositional() ? facts.options : facts.positionals).push_back(factsOf(*option));
    for (CLI::App* below : command.get_subcommands([](CLI::App*) { return true; }))
        facts.commands.push_back(factsOf(*below));
    return facts;
}

}  // namespace knuckle
