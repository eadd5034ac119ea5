#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/rig/import/import.h"

namespace knuckle {

/// The models of a run: each is read once, however many callers need it.
class Imports {
public:
    /// As importModel(). A model that was read with more than requested, such as clips or looks, is returned with that.
    /// @throws InputError as importModel().
    std::shared_ptr<const Model> read(const std::string& path, const ImportOptions& options);

    /// The number of reads.
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
