#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/states/block_file.h"
#include "app/states/frame_record.h"
#include "app/states/view_coding.h"
#include "sim/base/files/file_descriptor.h"

namespace knuckle {

/// A file of blocks that grows with a run: all that its exports and recordings are written from.
class FrameLog {
public:
    /// Opens the file and keeps its first bytes; 0: begins anew. @throws RunError.
    FrameLog(std::string path, uint64_t bytes);
    /// @throws RunError (full disk); then the file is as it was before.
    void add(const std::vector<std::string>& blocks);
    /// Waits until all is on the disk. @returns the file's size.
    uint64_t sync();

private:
    void cutTo(uint64_t bytes);
    [[noreturn]] void fail() const;

    std::string path_;
    FileDescriptor file_;
    uint64_t bytes_ = 0;
};

/// Blocks "frame N/...", "state N/...", "bodies N", "measures N", "densities N" of what the record has.
std::vector<std::string> packRecord(const FrameRecord& record, const ViewCoding& coding);
/// A record without anything if the log has none of that frame. @throws InputError.
FrameRecord unpackRecord(const BlockReader& log, uint64_t frame, const ViewCoding& coding);

}  // namespace knuckle
