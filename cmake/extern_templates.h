#pragma once

#include <Eigen/SVD>

// Quaternion::FromTwoVectors() needs these where the two are opposite; compiling them took every source that calls it
// six seconds. They are in precompiled.cpp.
extern template class Eigen::JacobiSVD<Eigen::Matrix<float, 2, 3>>;
extern template class Eigen::JacobiSVD<Eigen::Matrix<double, 2, 3>>;
