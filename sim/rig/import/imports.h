#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/rig/import/import.h"

namespace knuckle {

/// The models of a run: each is read once, however many ask for it.
class Imports {
public:
    /// As importModel(). What was read with more than is asked for, clips or how it looks, is given with that.
    /// @throws InputError as importModel().
    std::shared_ptr<const Model> read(const std::string& path, const ImportOptions& options);

    /// How often a file was read.
    size_t count() const { return models_.size(); }

private:
    struct Entry {
        std::string path;
        ImportOptions options;
        std::shared_ptr<const Model> model;
    };
    std::vector<Entry> models_;
};

}  // namespace knuckle
