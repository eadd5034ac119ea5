#pragma once

#include <optional>

#include "app/export/exporter.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

/// One CSV file for all frames: frame, body, object, name, position [m], quaternion (xyzw), velocity [m/s], angular
/// velocity [rad/s].
class BodyExport : public Exporter {
public:
    using Exporter::Exporter;
    ExportNeeds needs() const override { return {.bodies = true}; }
    void begin(const Scene& scene) override;
    void frame(const ExportFrame& frame) override;
    void finish() override { file_->commit(); }

private:
    std::optional<OutputFile> file_;
};

}  // namespace knuckle
