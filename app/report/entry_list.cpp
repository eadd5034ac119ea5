#include "app/report/entry_list.h"

#include <algorithm>
#include <cstddef>

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
    held_ = sorted_ = 0;
    return std::move(entries_);
}

/// What is beyond the limit stays so when more comes before it: so pictures can be dropped while entries are added.
void EntryList::trim()
{
    const auto added = entries_.begin() + static_cast<std::ptrdiff_t>(sorted_);
    std::sort(added, entries_.end(), isWorse);
    std::inplace_merge(entries_.begin(), added, entries_.end(), isWorse);
    sorted_ = entries_.size();
    size_t before = 0;
    held_ = 0;
    for (ReportEntry& entry : entries_) {
        const size_t bytes = entry.pictures.bytes() + entry.leftOutBytes;
        before += bytes;
        if (before <= limit_) {
            held_ += bytes;
        } else {
            entry.pictures.drop();
            entry.leftOutBytes = bytes;
        }
    }
}

}  // namespace knuckle
