// A box and a rope fall on the ground: where they are, a line each tenth of a second.
#include <knuckle/simulation.h>

#include <algorithm>
#include <cstdio>
#include <exception>

namespace {

constexpr float DIAMETER = 0.05f;

knuckle::World boxAndRope()
{
    knuckle::WorldBuilder builder(DIAMETER / 2);
    knuckle::Material wood;
    wood.name = "wood";
    wood.density = 600.0f;
    const uint32_t material = builder.addMaterial(wood);
    builder.addCollider(knuckle::Collider{});  // the ground: a plane at height 0

    builder.beginObject("box");
    builder.addBody("box", knuckle::boxLattice({4, 4, 4}, DIAMETER), material);
    builder.endObject({knuckle::Vector3f{0.0f, 0.6f, 0.0f}});

    knuckle::RopeSpec rope;
    rope.from = {0.3f, 0.3f, 0.0f};
    rope.to = {0.3f, 1.3f, 0.2f};
    rope.material = material;
    addRope(builder, "rope", rope);
    return builder.build();
}

}  // namespace

int main()
try {
    knuckle::Simulation simulation(boxAndRope());
    std::printf("%zu particles on %s\n", simulation.world().particles.size(), simulation.deviceName().c_str());
    for (int line = 0; line < 10; ++line) {
        while (simulation.time() < 0.1 * (line + 1)) simulation.step();
        float highest = 0.0f;
        for (const knuckle::Vector3f& place : simulation.positions()) highest = std::max(highest, place.y());
        std::printf("%.2f s: the box at %.3f m, the highest particle at %.3f m\n", simulation.time(),
                    simulation.bodies()[0].position.y(), highest);
    }
    std::printf("hash %016llx\n", static_cast<unsigned long long>(simulation.hash()));
} catch (const std::exception& error) {
    std::fprintf(stderr, "example: %s\n", error.what());
    return 1;
}
