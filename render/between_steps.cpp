#include "render/between_steps.h"

#include <string>

#include "sim/solver/fluid/foam_stage.h"

namespace knuckle {

BetweenSteps::BetweenSteps(const Gpu& gpu, const World& world) : world_(world)
{
    arrays_.reserve(6);  // the table refers to them
    const size_t particles = world.particles.size(), bodies = world.bodies.size();
    addArray("Positions", particles, &ParticleView::positions, &ViewState::positions);
    addArray("Velocities", particles, &ParticleView::velocities, &ViewState::velocities);
    addArray("Centres", bodies, &ParticleView::bodyCentres, &ViewState::bodyCentres);
    addArray("Rotations", bodies, &ParticleView::bodyRotations, &ViewState::bodyRotations);
    addArray("Colliders", 2 * world.colliders.size(), &ParticleView::colliderPlaces, &ViewState::colliderPlaces);
    addArray("Foam", FoamStage::capacity(world), &ParticleView::foamPlaces, &ViewState::foamPlaces);
    table_.add(Lifetime::Scratch, input_);
    places_ = Kernel(gpu, table_, "render/between/between_places.comp");
    poses_ = Kernel(gpu, table_, "render/between/between_poses.comp");
}

void BetweenSteps::addArray(const char* label, size_t size, GLuint ParticleView::*name,
                            std::vector<gpu::vec4> ViewState::*values)
{
    const std::string word = label;
    Array& array = arrays_.emplace_back(Array{name, values, {"before" + word, size}, {"between" + word, size}, {}});
    table_.add(Lifetime::State, array.before);
    table_.add(Lifetime::Scratch, array.between);
    table_.add("after" + word, array.after, elementType<gpu::vec4>(), Lifetime::Scratch);
}

void BetweenSteps::begin(const ParticleView& before)
{
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    for (Array& array : arrays_) {
        const size_t bytes = array.before.size() * sizeof(gpu::vec4);
        array.before.copy(RawBuffer::standIn("before", before.*array.name, bytes), bytes);
    }
}

ParticleView BetweenSteps::at(const ParticleView& after, double part)
{
    ParticleView view = after;
    for (Array& array : arrays_) {
        array.after = RawBuffer::standIn("after", after.*array.name, array.before.size() * sizeof(gpu::vec4));
        view.*array.name = array.between.id();
    }
    const auto foam = static_cast<uint32_t>(arrays_.back().before.size());
    const gpu::BetweenInput input{static_cast<float>(part),
                                  world_.settings.timeStep,
                                  static_cast<uint32_t>(world_.particles.size()),
                                  static_cast<uint32_t>(world_.bodies.size()),
                                  static_cast<uint32_t>(world_.colliders.size()),
                                  foam,
                                  {},
                                  {}};
    input_.upload({&input, 1});
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    places_.dispatch(timer_, groupsFor(input.particleCount));
    poses_.dispatch(timer_, groupsFor(input.bodyCount + input.colliderCount + input.foamCount));
    return view;
}

void BetweenSteps::read(ViewState& view) const
{
    for (const Array& array : arrays_)
        if (!(view.*array.values).empty()) view.*array.values = array.between.download();
}

}  // namespace knuckle
