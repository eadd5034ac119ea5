#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/export/exporter.h"
#include "app/json/json.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

/// Names and values of Measures, also for `--stats`, in the order of docs/output.md.
std::vector<std::pair<std::string, Json>> measureFields(const Measures& m);

/// One CSV file for all frames: the Measures of each.
class MeasureExport : public Exporter {
public:
    using Exporter::Exporter;
    ExportNeeds needs() const override { return {.measures = true}; }
    void begin(const Scene& scene) override;
    void frame(const ExportFrame& frame) override;
    void finish() override { file_->commit(); }

private:
    std::optional<OutputFile> file_;
};

}  // namespace knuckle
