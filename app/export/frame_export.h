#pragma once

#include "app/export/exporters.h"
#include "app/states/frame_record.h"

namespace knuckle {

/// Hands a frame to exporters. @throws std::logic_error if the record lacks what they need.
void exportFrame(const FrameRecord& record, const World& world, const ExportNeeds& needs, const Exporters& exporters);

/// Shows a frame before those that are exported to exporters that need every one.
void passFrame(const FrameRecord& record, const World& world, const Exporters& exporters);

/// While it lives, exporters have a device to draw with.
class OpenExporters {
public:
    /// Both must outlive it.
    OpenExporters(const Exporters& exporters, Gpu& gpu);
    ~OpenExporters();
    OpenExporters(const OpenExporters&) = delete;
    OpenExporters& operator=(const OpenExporters&) = delete;

private:
    const Exporters& exporters_;
};

}  // namespace knuckle
