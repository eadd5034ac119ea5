#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/export/exporter.h"

namespace knuckle {

using Exporters = std::vector<std::unique_ptr<Exporter>>;

/// One exporter for each "KIND=PATH", in the order of the table of kinds. @throws InputError for an unknown kind or a
/// path with the wrong ending.
Exporters makeExporters(const std::vector<std::string>& options);

/// The union of their needs.
ExportNeeds needsOf(const Exporters& exporters);

/// A line of `--help` for each kind: how to write it, and what it contains.
std::string exportHelp();

}  // namespace knuckle
