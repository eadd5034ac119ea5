#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "render/output/frame_names.h"

namespace knuckle {

/// Inputs and outputs of a command. check() refuses an output that would be lost, or would destroy an input: by the
/// identity of the files, whatever their paths look like. Streams may be named any number of times.
class RunPaths {
public:
    void reads(const std::string& file);
    /// Adds a model and the files that it names, as far as they are known: for glTF and OBJ.
    void readsModel(const std::string& file);
    void readsFolder(const std::string& folder);
    /// @throws InputError as OutputPlace::of(), like writesFrames().
    void writes(const std::string& file);
    void writesFrames(const FrameNames& names);
    /// @throws InputError.
    void check() const;

private:
    struct Place {
        std::string given, path;  ///< `path`: absolute, without links.
        bool exists = false, isStream = false;
        bool keeps = false;  ///< Of a stream: a pipe or a file, no device.
        dev_t device = 0;
        ino_t inode = 0;
        std::optional<FrameNames> frames = {};  ///< Of a folder.
    };
    static Place outputAt(const std::string& path);
    static Place inputAt(const std::string& path);
    static bool isSame(const Place& a, const Place& b);
    static bool isFrameOf(const Place& folder, const Place& file);
    void refuseInput(const Place& output, const Place& input) const;
    void checkLinks(const Place& folder) const;

    std::vector<Place> inputs_, folders_, outputs_;
};

}  // namespace knuckle
