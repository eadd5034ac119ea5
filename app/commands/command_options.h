#pragma once

#include <CLI/CLI.hpp>
#include <string>

/// What options of several commands have in common.
namespace knuckle {

/// CLI::Range takes what is no number for one in range.
CLI::Validator numberBetween(double lowest, double highest);

/// Once parsed: @throws InputError for an option of the program or its command whose value is empty.
void refuseEmptyValues(const CLI::App& program);

}  // namespace knuckle
