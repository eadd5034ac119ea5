#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <vector>

#include "app/compare/report_outputs.h"

/// What options of several commands share.
namespace knuckle {

/// Unlike CLI::Range, refuses text that is not a number.
CLI::Validator numberBetween(double lowest, double highest);

/// Before the words in the name of a validator, which help does not show.
inline constexpr const char* WORDS_PREFIX = "words:";
/// Only one of these words; the option's help names them.
CLI::Validator oneOf(const std::vector<std::string>& words);
/// Any value; completion offers these words.
CLI::Validator offered(const std::vector<std::string>& words);
CLI::Validator offered(std::span<const char* const> words);
/// Words of --codec.
std::vector<std::string> codecWords();

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
