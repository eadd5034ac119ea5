#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/compare/report_outputs.h"

/// What options of several commands share.
namespace knuckle {

/// Unlike CLI::Range, refuses text that is not a number.
CLI::Validator numberBetween(double lowest, double highest);

/// Whether a value of --quality is a scene's, not JPEG's.
bool isQualityWord(const std::string& quality);
/// That of JPEG. @throws InputError for neither.
int jpegQuality(const std::string& quality);

/// After parsing: @throws InputError for an option of the program or its command with an empty value.
void refuseEmptyValues(const CLI::App& program);

/// --report, --report-all, --report-size, --junit, --annotations.
void addReportOptions(CLI::App& command, ReportOptions& options);
/// After parsing. @param json whether --json is given. @throws InputError for options that make no sense together.
void checkReportOptions(const ReportOptions& options, bool json);

}  // namespace knuckle
