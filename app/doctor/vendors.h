#pragma once

#include <string>
#include <vector>

namespace knuckle {

/// A driver that libEGL finds by its description.
struct EglVendor {
    std::string file;     ///< The description.
    std::string library;  ///< That it names, empty if it cannot be read.
};

/// Those of libglvnd, from where the environment says, else from its usual folders below `root`.
std::vector<EglVendor> eglVendors(const std::string& root);
/// For people: "/etc/glvnd/egl_vendor.d or /usr/share/glvnd/egl_vendor.d", or what the environment says.
std::string eglVendorPlaces(const std::string& root);

}  // namespace knuckle
