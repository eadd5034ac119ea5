#include "app/commands/command_options.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <optional>

#include "sim/world/errors.h"

namespace knuckle {

namespace {

/// The whole text as a number, perhaps one that is none or has no end.
std::optional<double> numberIn(const std::string& text)
{
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return text.empty() || end != text.c_str() + text.size() ? std::nullopt : std::optional(value);
}

}  // namespace

CLI::Validator numberBetween(double lowest, double highest)
{
    const auto check = [=](std::string& text) -> std::string {
        const auto value = numberIn(text);
        if (value && *value >= lowest && *value <= highest) return {};
        return fmt::format("{} is {}; give one from {:g} to {:g}", text,
                           value && std::isfinite(*value) ? "out of range" : "no finite number", lowest, highest);
    };
    return {check, fmt::format("FLOAT in [{:g} - {:g}]", lowest, highest)};
}

double rateIn(const std::string& text)
{
    const size_t slash = text.find('/');
    const auto whole = numberIn(text.substr(0, slash));
    const auto parts = slash == std::string::npos ? std::optional(1.0) : numberIn(text.substr(slash + 1));
    const double rate = whole && parts ? *whole / *parts : NAN;
    if (parts.value_or(0.0) > 0.0 && rate >= LOWEST_RATE && rate <= HIGHEST_RATE) return rate;
    throw InputError(fmt::format("--fps {}: must be a number or a fraction from {:g} to {:g}, for instance 25 or "
                                 "24000/1001",
                                 text, LOWEST_RATE, HIGHEST_RATE));
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
