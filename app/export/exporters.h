#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/export/exporter.h"

namespace knuckle {

using Exporters = std::vector<std::unique_ptr<Exporter>>;

/// One exporter for each "KIND=PATH", in the order of the table of kinds. @throws InputError for an unknown kind and a
/// path whose ending is not of it.
Exporters makeExporters(const std::vector<std::string>& options);

/// What any of them needs.
ExportNeeds needsOf(const Exporters& exporters);

/// A line of `--help` for each kind: what to say, and what is written.
std::string exportHelp();

}  // namespace knuckle
