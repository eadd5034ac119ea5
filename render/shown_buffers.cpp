#include "render/shown_buffers.h"

#include "sim/solver/fluid/form_stage.h"
#include "sim/solver/strand/strand_order.h"

namespace knuckle {

ShownBuffers::ShownBuffers(const World& world)
    : balls_("balls", FormStage::isNeeded(world) ? world.particles.size() : 0),
      wholeDistances_("wholeDistances", canTear(world) ? strandOrder(world).nodeCount : 0)
{
}

void ShownBuffers::addTo(BufferTable& table)
{
    table.add("positions", positions_, elementType<gpu::vec4>(), Lifetime::Scratch);
    table.add("velocities", velocities_, elementType<gpu::vec4>(), Lifetime::Scratch);
    table.add("bodyCentres", bodyCentres_, elementType<gpu::vec4>(), Lifetime::Scratch);
    table.add("bodyRotations", bodyRotations_, elementType<gpu::vec4>(), Lifetime::Scratch);
    table.add("colliderPlaces", colliderPlaces_, elementType<gpu::vec4>(), Lifetime::Scratch);
    table.add("foamPlaces", foamPlaces_, elementType<gpu::vec4>(), Lifetime::Scratch);
    table.add("fluidForms", fluidForms_, elementType<uint32_t>(), Lifetime::Scratch);
    table.add("distanceStates", distanceStates_, elementType<gpu::vec4>(), Lifetime::Scratch);
}

void ShownBuffers::attach(const ParticleView& view)
{
    // Needed even for equal names: the solver may have enlarged a buffer and got its old name again.
    const auto vectors = [](const char* name, GLuint buffer, size_t count) {
        return RawBuffer::standIn(name, buffer, count * sizeof(gpu::vec4));
    };
    positions_ = vectors("positions", view.positions, view.particleCount);
    velocities_ = vectors("velocities", view.velocities, view.particleCount);
    bodyCentres_ = vectors("bodyCentres", view.bodyCentres, view.bodyCount);
    bodyRotations_ = vectors("bodyRotations", view.bodyRotations, view.bodyCount);
    colliderPlaces_ = vectors("colliderPlaces", view.colliderPlaces, size_t{2} * view.colliderCount);
    foamCount_ = view.foamCount;
    foamPlaces_ = vectors("foamPlaces", view.foamPlaces, foamCount_);
    fluidForms_ = RawBuffer::standIn("fluidForms", view.fluidForms != 0 ? view.fluidForms : balls_.id(),
                                     balls_.size() * sizeof(uint32_t));
    const bool tears = view.distanceStates != 0;
    distanceStates_ = vectors("distanceStates", tears ? view.distanceStates : wholeDistances_.id(),
                              tears ? view.distanceCount : wholeDistances_.size());
}

}  // namespace knuckle
