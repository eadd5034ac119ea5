#pragma once

namespace knuckle {

/// Types of the numbers of a glTF accessor (glTF 2.0, 3.6.2.2).
inline constexpr int GLTF_BYTE = 5120, GLTF_UNSIGNED_BYTE = 5121, GLTF_SHORT = 5122, GLTF_UNSIGNED_SHORT = 5123,
                     GLTF_UNSIGNED_INT = 5125, GLTF_FLOAT = 5126;

}  // namespace knuckle
