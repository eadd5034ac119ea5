#include "render/stored_view.h"

#include <algorithm>
#include <stdexcept>

#include "sim/solver/fluid/foam_stage.h"
#include "sim/solver/fluid/form_stage.h"
#include "sim/solver/strand/strand_order.h"

namespace knuckle {

StoredView::StoredView(const World& world)
    : world_(world), positions_("stored positions", world.particles.size()),
      velocities_("stored velocities", world.particles.size()), centres_("stored centres", world.bodies.size()),
      rotations_("stored rotations", world.bodies.size()), colliders_("stored colliders", 2 * world.colliders.size()),
      foam_("stored foam", FoamStage::capacity(world)),
      distances_("stored distances", canTear(world) ? strandOrder(world).nodeCount : 0),
      forms_("stored forms", FormStage::isNeeded(world) ? world.particles.size() : 0),
      ages_("stored ages", world.shown.ages ? world.particles.size() : 0),
      contactForces_("stored forces", world.shown.contactForces ? world.particles.size() : 0)
{
}

ParticleView StoredView::upload(const ViewState& state)
{
    const auto fill = []<typename T>(Buffer<T>& buffer, const std::vector<T>& values) {
        if (values.size() != buffer.size()) throw std::logic_error("the stored state is of another world");
        if (!values.empty()) buffer.upload(values);
        return buffer.id();
    };
    ParticleView view;
    view.positions = fill(positions_, state.positions);
    view.velocities = fill(velocities_, state.velocities);
    view.bodyCentres = fill(centres_, state.bodyCentres);
    view.bodyRotations = fill(rotations_, state.bodyRotations);
    view.colliderPlaces = fill(colliders_, state.colliderPlaces);
    // A file of an earlier version has no foam.
    const std::vector<gpu::vec4> none(foam_.size());
    view.foamPlaces = fill(foam_, state.foamPlaces.empty() ? none : state.foamPlaces);
    view.foamCount = static_cast<uint32_t>(foam_.size());
    if (!state.fluidForms.empty()) view.fluidForms = fill(forms_, state.fluidForms);
    // A file may have what this picture does not show.
    if (world_.shown.ages && !state.ages.empty()) view.ages = fill(ages_, state.ages);
    if (world_.shown.contactForces && !state.contactForces.empty())
        view.contactForces = fill(contactForces_, state.contactForces);
    // None is stored where none is torn; bits are stored in whole words.
    std::vector<gpu::vec4> distances(distances_.size());
    for (size_t i = 0; i < std::min(distances.size(), state.tornDistances.size()); ++i)
        distances[i].z = state.tornDistances[i] ? 1.0f : 0.0f;
    view.distanceStates = distances_.size() > 0 ? fill(distances_, distances) : 0;
    view.distanceCount = static_cast<uint32_t>(distances_.size());
    view.particleCount = static_cast<uint32_t>(world_.particles.size());
    view.bodyCount = static_cast<uint32_t>(world_.bodies.size());
    view.colliderCount = static_cast<uint32_t>(world_.colliders.size());
    view.solidCount = world_.solidCount();
    view.radius = world_.particleRadius;
    view.fluidSpacing = world_.fluidSpacing;
    return view;
}

}  // namespace knuckle
