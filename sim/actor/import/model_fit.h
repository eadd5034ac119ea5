#pragma once

#include <string>

namespace knuckle {

/// The axis of a file that points up, where the file does not say so itself.
enum class UpAxis { Y, Z };
/// Which models are moved so that their lowest point is at height 0 and the middle of their bounds over the origin:
/// none, those that stand ten times their size away, all.
enum class Centering { Never, WhereFar, Always };

/// How large a model is and where it stands.
struct ModelFit {
    double scale = 0.0;   ///< Metres per file unit; 0: what the file says, else guessed and noted.
    double height = 0.0;  ///< [m]; 0: by scale.
    UpAxis up = UpAxis::Y;
    Centering centering = Centering::Never;

    bool operator==(const ModelFit&) const = default;
};

/// A model in a file.
struct ModelSource {
    std::string file;  ///< Its path; empty: not known.
    ModelFit fit;
};

}  // namespace knuckle
