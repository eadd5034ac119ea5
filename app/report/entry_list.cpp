#include "app/report/entry_list.h"

#include <algorithm>

namespace knuckle {

void EntryList::add(ReportEntry entry)
{
    const std::lock_guard lock(mutex_);
    held_ += entry.pictures.bytes();
    entries_.push_back(std::move(entry));
    if (held_ > 2 * limit_) trim();
}

std::vector<ReportEntry> EntryList::take()
{
    const std::lock_guard lock(mutex_);
    trim();
    held_ = 0;
    return std::move(entries_);
}

/// What is beyond the limit stays so when more comes before it: so pictures can be dropped while entries are added.
void EntryList::trim()
{
    std::sort(entries_.begin(), entries_.end(), isWorse);
    size_t before = 0;
    held_ = 0;
    for (ReportEntry& entry : entries_) {
        const size_t bytes = entry.pictures.bytes() + entry.leftOutBytes;
        before += bytes;
        if (before <= limit_) {
            held_ += bytes;
        } else {
            entry.pictures = {};
            entry.leftOutBytes = bytes;
        }
    }
}

}  // namespace knuckle
