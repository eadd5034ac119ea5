#pragma once

#include <CLI/CLI.hpp>
#include <string>

/// What options of several commands have in common.
namespace knuckle {

/// Frames per second, as the scene's schema has them.
inline constexpr double LOWEST_RATE = 10.0, HIGHEST_RATE = 480.0;

/// CLI::Range takes what is no number for one in range.
CLI::Validator numberBetween(double lowest, double highest);

/// Frames per second of "25" or "24000/1001". @throws InputError that names `--fps`.
double rateIn(const std::string& text);

/// Once parsed: @throws InputError for an option of the program or its command whose value is empty.
void refuseEmptyValues(const CLI::App& program);

}  // namespace knuckle
