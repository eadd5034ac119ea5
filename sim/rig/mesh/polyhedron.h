#pragma once

#include <vector>

#include "sim/rig/mesh/solid.h"

namespace knuckle {

/// A half space that a convex solid lies in: those with normal · x <= distance.
struct Facet {
    Eigen::Vector3f normal;  ///< Unit, outwards.
    float distance = 0.0f;   ///< Of its plane from the origin, along the normal [m].
};

/// The facets of a closed convex polyhedron of a few, as wedges and stones of an arch are; empty for all other solids.
std::vector<Facet> facetsOf(const Solid& solid);
/// Whether these are facets of a box along the axes, which a lattice fills as well.
bool isBoxAlongAxes(const std::vector<Facet>& facets);

/// Places of particles that fill a convex polyhedron so that it has flat facets: the outermost are half a diameter
/// behind each, evenly from edge to edge. So where two polyhedra share a facet their particles face each other in
/// pairs, a diameter apart. Empty where it is too thin for them.
std::vector<Eigen::Vector3f> fillPolyhedron(const std::vector<Facet>& facets, float diameter);

}  // namespace knuckle
