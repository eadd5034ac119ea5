#include "tests/physics/rope/capstan_fixture.h"

#include <algorithm>
#include <cmath>

namespace knuckle::test {

namespace {

constexpr float ARC = Capstan::RADIUS + 0.5f * Capstan::THICKNESS, APART = 0.5f, PITCH = 1.6f * Capstan::THICKNESS;

using Places = std::vector<Vector3f>;

/// Goes straight on from the last place.
void addStraight(Places& out, const Vector3f& to)
{
    const Vector3f from = out.back();
    const int count = static_cast<int>(std::ceil((to - from).norm() / (0.999f * Capstan::THICKNESS)));
    for (int k = 1; k <= count; ++k)
        out.push_back(from + (to - from) * (static_cast<float>(k) / static_cast<float>(count)));
}

/// Goes on about a drum, clockwise.
void addArc(Places& out, const Vector3f& axis, double from, double angle, float pitch)
{
    const float z = out.back().z();
    const int count = static_cast<int>(std::ceil(angle * 1.01 * ARC / (0.999 * Capstan::THICKNESS)));
    for (int k = 1; k <= count; ++k) {
        const double turn = angle * k / count, at = from - turn;
        out.push_back({axis.x() + ARC * static_cast<float>(std::cos(at)),
                       axis.y() + ARC * static_cast<float>(std::sin(at)),
                       z + pitch * static_cast<float>(turn / (2 * M_PI))});
    }
}

Places placesOf(const Capstan& spec)
{
    const bool corners = spec.way == Capstan::Way::Corners;
    const Vector3f left(corners ? -APART : 0.0f, 0, 0), right = -left;
    Places out{left + Vector3f(-ARC, -spec.hang, 0)};
    addStraight(out, left + Vector3f(-ARC, 0, 0));
    if (corners) {
        addArc(out, left, M_PI, 0.5 * M_PI, 0);
        addStraight(out, right + Vector3f(0, ARC, 0));
        addArc(out, right, 0.5 * M_PI, 0.5 * M_PI, 0);
    } else {
        const bool wound = spec.way == Capstan::Way::Wound;
        addArc(out, left, M_PI, wound ? 3 * M_PI : M_PI, wound ? PITCH : 0.0f);
    }
    addStraight(out, out.back() - Vector3f(0, spec.hang, 0));
    return out;
}

/// A cube of 27 particles that hangs by the middle of its upper side. @returns that particle.
uint32_t addBoxLoad(WorldBuilder& builder, const Vector3f& place, float mass, float speed)
{
    Material material;
    material.density = mass / (27 * std::pow(Capstan::THICKNESS, 3.0f));
    const uint32_t index = builder.addMaterial(material);
    builder.beginObject("load");
    builder.addBody("load", boxLattice({3, 3, 3}, Capstan::THICKNESS), index);
    builder.endObject({place - Vector3f(0, Capstan::THICKNESS, 0)}, {speed, 0, 0});
    return particleAt(builder, place);
}

void addDrums(WorldBuilder& builder, const Capstan& spec, const Vector3f& at)
{
    Collider drum;
    drum.shape = ColliderShape::Capsule;
    drum.radius = Capstan::RADIUS;
    drum.halfHeight = 2.0f;
    drum.orientation = Quaternionf(Eigen::AngleAxisf(static_cast<float>(0.5 * M_PI), Vector3f::UnitX()));
    drum.staticFriction = drum.kineticFriction = spec.friction;
    const bool corners = spec.way == Capstan::Way::Corners;
    drum.position = at - Vector3f(corners ? APART : 0.0f, 0, 0);
    builder.addCollider(drum);
    if (!corners) return;
    drum.position = at + Vector3f(APART, 0, 0);
    builder.addCollider(drum);
}

/// @param ends particles of the loads, if these are boxes.
void addRow(WorldBuilder& builder, const Capstan& spec, const Places& places, const uint32_t (&ends)[2])
{
    builder.beginObject("rope");
    Strand row;
    for (size_t k = 0; k < places.size(); ++k) {
        const bool first = k == 0, last = k + 1 == places.size();
        if (k > 0) row.restLengths.push_back((places[k] - places[k - 1]).norm());
        if (spec.boxes && (first || last)) {
            row.particles.push_back(ends[first ? 0 : 1]);
            continue;
        }
        Particle particle;
        particle.position = particle.restPosition = places[k];
        particle.selfMargin = ROPE_MARGIN;
        particle.mass = first ? spec.left : last ? spec.right : spec.massPerLength * Capstan::THICKNESS;
        row.particles.push_back(builder.addLooseParticle(particle));
    }
    builder.addStrand(row);
    builder.endObject({});
}

}  // namespace

double Capstan::angle() const
{
    return way == Way::Wound ? 3 * M_PI : M_PI;
}

World Capstan::world() const
{
    Settings settings;
    settings.substeps = substeps;
    WorldBuilder builder(0.5f * THICKNESS, settings);
    Material material;
    material.staticFriction = material.kineticFriction = friction;
    builder.addMaterial(material);
    const Vector3f at(1, 2, 3);
    addDrums(builder, *this, at);
    Places places = placesOf(*this);
    for (Vector3f& place : places) place += at;
    uint32_t ends[2] = {NO_INDEX, NO_INDEX};
    if (boxes) {
        ends[0] = addBoxLoad(builder, places.front(), left, -swing);
        ends[1] = addBoxLoad(builder, places.back(), right, swing);
    }
    addRow(builder, *this, places, ends);
    return builder.build();
}

CapstanRun runCapstan(const Capstan& spec, double seconds)
{
    const World world = spec.world();
    Solver solver(gpu(), world);
    const auto& nodes = world.strands[0].particles;
    const double atStart = energyOf(world, solver.readParticles()), step = world.settings.timeStep;
    double length = 0.0;
    for (const float rest : world.strands[0].restLengths) length += rest;
    CapstanRun out;
    const int frames = static_cast<int>(std::lround(seconds / step));
    for (int frame = 1; frame <= frames; ++frame) {
        run(solver, world, step);
        const ParticleState state = solver.readParticles();
        double now = 0.0;
        for (size_t k = 0; k < nodes.size(); ++k) {
            const Vector3f& x = state.positions[nodes[k]];
            if (k > 0) now += (x - state.positions[nodes[k - 1]]).norm();
            for (const Collider& drum : world.colliders)
                out.sunk = std::max(out.sunk, double(0.5f * Capstan::THICKNESS - regionDistance(drum, x)));
        }
        out.stretched = std::max(out.stretched, std::abs(now - length));
        out.gained = std::max(out.gained, energyOf(world, state) - atStart);
        out.moved = world.particles[nodes[0]].position.y() - state.positions[nodes[0]].y();
        if (2 * frame <= frames) out.between = out.moved;
    }
    return out;
}

}  // namespace knuckle::test
