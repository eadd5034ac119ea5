#pragma once

#include <mutex>

#include "app/report/report_entry.h"

namespace knuckle {

/// The entries of a report, the worst first, with no more pictures than a report may hold: those of the worst entries
/// are kept. Threads may add at the same time; what comes out does not depend on their order.
class EntryList {
public:
    /// @param pictureBytes how many bytes of PNG files are kept. Twice as many may be in memory.
    explicit EntryList(size_t pictureBytes) : limit_(pictureBytes) {}

    void add(ReportEntry entry);
    /// When all are added.
    std::vector<ReportEntry> take();

private:
    void trim();

    std::mutex mutex_;
    std::vector<ReportEntry> entries_;
    size_t limit_ = 0, held_ = 0;
    size_t sorted_ = 0;  ///< So many entries are in order.
};

}  // namespace knuckle
