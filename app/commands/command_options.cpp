#include "app/commands/command_options.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <optional>

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

void refuseEmptyValues(const CLI::App& program)
{
    for (const CLI::App* command : program.get_subcommands()) refuseEmptyValues(*command);
    for (const CLI::Option* option : program.get_options())
        for (const std::string& value : option->results())
            if (value.empty() && option->get_expected_max() > 0)
                throw InputError(fmt::format("{}: its value is empty; give one, or leave it out",
                                             option->get_positional() ? option->get_name(true) : option->get_name()));
}

}  // namespace knuckle
