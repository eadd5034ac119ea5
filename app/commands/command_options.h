#pragma once

#include <CLI/CLI.hpp>
#include <string>

/// What options of several commands share.
namespace knuckle {

/// Unlike CLI::Range, refuses text that is not a number.
CLI::Validator numberBetween(double lowest, double highest);

/// After parsing: @throws InputError for an option of the program or its command with an empty value.
void refuseEmptyValues(const CLI::App& program);

}  // namespace knuckle
