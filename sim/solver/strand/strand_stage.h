#pragma once

#include "sim/solver/measure/measure.h"
#include "sim/solver/stage.h"
#include "sim/solver/strand/strand_order.h"

namespace knuckle {

/// Ropes and cloth: strands of distance constraints (World::strands), each solved at once by one thread. Strands are
/// coloured: no two of a colour share a particle that moves, so each may move its own in place.
class StrandStage : public Stage {
public:
    /// Strands that are solved together.
    struct Color {
        uint32_t begin = 0, end = 0;
        bool hasBodies = false;  ///< Whether particles of bodies are among them.
    };

    static bool isNeeded(const World& world);
    explicit StrandStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    /// The largest load of a strand over its lightest node.
    float load() const { return load_; }
    /// Whether contacts of ropes with colliders are solved with them.
    bool touchesColliders() const { return touches_; }
    /// Whether a load is so heavy that floats lose what is light: strands are solved in doubles.
    bool isHeavy() const { return heavy_; }
    const std::vector<Color>& colors() const { return colors_; }
    /// One dispatch a colour. @param first whether it is the first iteration of its substep.
    void solve(Recorder& recorder, bool first) const;
    /// Adds the measures of ropes and cloth. Stalls until the GPU is done.
    void measure(Measures& out, const World& world, const ParticleState& particles) const;
    /// Per distance of all strands of the World, in its order, whether it is torn. Stalls until the GPU is done.
    std::vector<bool> tornDistances(const World& world) const;
    /// Index into distanceStates of a distance of a strand of the World.
    size_t stateOf(const World& world, size_t strand, size_t distance) const;

    Buffer<gpu::uvec4> strands;         ///< First and last node, assembly.
    Buffer<gpu::uvec4> distanceNodes;   ///< Mover, rank, particle, inverse mass or split (distance_nodes.glsl).
    Buffer<gpu::vec4> distanceLinks;    ///< Per node, to the next: rest length, compliance; force, length that tear.
    Buffer<gpu::vec4> distanceStates;   ///< Per node, to the next: multiplier [kg m], tension [N], 1 if torn.
    Buffer<gpu::vec4> distanceFactors;  ///< Per node; used only within a dispatch. Of doubles for heavy loads.
    Buffer<gpu::uvec2> strandReleases;  ///< Per strand: first substeps without its first and last link, or NO_SUBSTEP.
    Buffer<uint32_t> ropeNodes;         ///< Nodes whose contacts with colliders are solved with their rope.
    Buffer<uint32_t> ropeMovers;        ///< Per mover, 1 + the one of these that it is; 0 if none.
    Buffer<gpu::vec4>
        nodeContacts;  ///< Per node, five: stiffness, push of its contacts; its moves (node_contacts.glsl).

private:
    void recordTouch(Recorder& recorder, const Kernel& kernel) const;
    void uploadRopes(const StageSetup& setup, const std::vector<gpu::uvec4>& nodes);

    /// From this load on floats lose what is light: two bodies of 100 and 2000 times a node's weight, on a rope between
    /// them, are thrown apart.
    static constexpr float HEAVY_LOAD = 100.0f;

    float load_;
    bool heavy_ = load_ > HEAVY_LOAD, touches_, letsGo_;
    float contactStiffness_ = 0.0f,
          contactHold_ = 0.0f;  ///< Per mass of a node: along the normal, and where it sticks.
    std::vector<Color> colors_;
    StrandOrder order_;
    Defines plain_ = definesOf({{"HEAVY", heavy_}, {"CONTACTS", touches_}});
    Defines firsts_ = with(letsGo_ ? with(plain_, "LETS_GO") : plain_, "FIRST_ITERATION");
    Pass first_{*this, "strand/strand_solve", firsts_};
    Pass later_{*this, "strand/strand_solve", plain_};
    Pass firstWithBodies_{*this, "strand/strand_solve", with(firsts_, "BODIES")};
    Pass laterWithBodies_{*this, "strand/strand_solve", with(plain_, "BODIES")};
    Pass firstTouch_{*this, "strand/rope_touch", with({}, "FIRST_ITERATION"), touches_};
    Pass laterTouch_{*this, "strand/rope_touch", {}, touches_};
    Pass firstPush_{*this, "strand/rope_push", with({}, "FIRST_ITERATION"), touches_};
    Pass laterPush_{*this, "strand/rope_push", {}, touches_};
};

}  // namespace knuckle
