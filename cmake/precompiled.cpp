// Belongs to the headers that are precompiled for all: what these declare as compiled elsewhere.
#include "cmake/extern_templates.h"

template class Eigen::JacobiSVD<Eigen::Matrix<float, 2, 3>>;
template class Eigen::JacobiSVD<Eigen::Matrix<double, 2, 3>>;
