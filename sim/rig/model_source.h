#pragma once

#include <string>

namespace knuckle {

/// The axis of a file that points up, if the file does not say so itself.
enum class UpAxis { Y, Z };
/// Which models are moved so that their lowest point is at height 0 and the middle of their bounds over the origin:
/// none, those ten times their size away or further, all.
enum class Centering { Never, WhereFar, Always };

/// How large a model is and where it stands.
struct ModelFit {
    double scale = 0.0;   ///< Metres per file unit; 0: from the file, else guessed and noted.
    double height = 0.0;  ///< [m]; 0: by scale.
    UpAxis up = UpAxis::Y;
    Centering centering = Centering::Never;

    bool operator==(const ModelFit&) const = default;
};

/// The part of a file that becomes an actor.
struct ModelPick {
    /// Name of the root bone, or a pattern (name_pattern.h), of the skeleton whose bones and meshes are taken. Empty:
    /// the only one. `*`: everything, as one.
    std::string skeleton;
    bool split = false;  ///< A model without a skeleton: a body for each separate part of its mesh.

    bool operator==(const ModelPick&) const = default;
};
/// For callers without use for a skeleton.
inline const std::string ALL_SKELETONS = "*";

/// A model in a file.
struct ModelSource {
    std::string file;  ///< Its path; empty: unknown.
    ModelFit fit;
    ModelPick pick = {};
};

}  // namespace knuckle
