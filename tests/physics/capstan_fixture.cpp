#include "tests/physics/capstan_fixture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstdio>
#include "sim/solver/state_values.h"
#include "shared/counters.h"

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

}  // namespace

double Capstan::angle() const
{
    return way == Way::Wound ? 3 * M_PI : M_PI;
}

World Capstan::world() const
{
    Settings settings;
    settings.substeps = substeps;
    if (std::getenv("ITER")) settings.iterations = static_cast<uint32_t>(std::atoi(std::getenv("ITER")));
    if (std::getenv("DT")) {
        settings.timeStep /= static_cast<float>(substeps);
        settings.substeps = 1;
    }
    WorldBuilder builder(0.5f * THICKNESS, settings);
    Material material;
    material.staticFriction = material.kineticFriction = friction;
    builder.addMaterial(material);
    const float far = std::getenv("POS") ? float(std::atof(std::getenv("POS"))) : 0.0f;
    const Vector3f at(far, far, far);
    Collider drum;
    drum.shape = ColliderShape::Capsule;
    drum.radius = RADIUS;
    drum.halfHeight = 2.0f;
    drum.orientation = Quaternionf(Eigen::AngleAxisf(static_cast<float>(0.5 * M_PI), Vector3f::UnitX()));
    drum.staticFriction = drum.kineticFriction = friction;
    for (const float side : {-APART, APART}) {
        drum.position.x() = way == Way::Corners ? side : 0.0f;
        drum.position += at;
        builder.addCollider(drum);
        drum.position -= at;
        if (way != Way::Corners) break;
    }
    builder.beginObject("rope");
    const Places places = placesOf(*this);
    Strand row;
    for (size_t k = 0; k < places.size(); ++k) {
        Particle particle;
        particle.position = particle.restPosition = at + places[k];
        particle.selfMargin = ROPE_MARGIN;
        particle.mass = massPerLength * THICKNESS;
        if (k == 0) particle.mass = left;
        if (k + 1 == places.size()) particle.mass = right;
        row.particles.push_back(builder.addLooseParticle(particle));
        if (k > 0) row.restLengths.push_back((places[k] - places[k - 1]).norm());
    }
    builder.addStrand(row);
    builder.endObject({});
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
        if (std::getenv("V"))
            printf("%d sunk %.5f stretch %.5f energy %.4f moved %.5f\n", frame, out.sunk, now - length, energyOf(world, state) - atStart, out.moved);
        if (std::getenv("DUMP") && frame >= std::atoi(std::getenv("DUMP")) && frame < std::atoi(std::getenv("DUMP")) + 5) {
            printf("search %llu\n", (unsigned long long)solver.searchCount());
            for (size_t k = 0; k < nodes.size(); ++k) {
                const Vector3f& x = state.positions[nodes[k]];
                const Vector3f& v = state.velocities[nodes[k]];
                printf("  %zu gap %.6f z %.6f v %.5f %.5f %.5f y %.4f\n", k, regionDistance(world.colliders[0], x) - 0.02f, x.z(), v.x(), v.y(), v.z(), x.y());
            }
        }
        if (std::getenv("IMP") && frame >= std::atoi(std::getenv("IMP")) && frame < std::atoi(std::getenv("IMP")) + 6) {
            const SolverState saved = solver.saveState();
            const auto impulses = readState<gpu::vec4>(saved.stages, "colliderImpulses");
            const auto pairs = readState<gpu::uvec2>(saved.stages, "colliderPairs");
            const auto slides = readState<float>(saved.stages, "colliderMeans");
            const auto c = readState<gpu::Counters>(saved.stages, "countersBlock")[0];
            const size_t base = c.listParity * impulses.size() / 2;
            const double unit = 9.81 * step * step * 0.1818 / 1;
            std::printf("frame %d:\n", frame);
            for (size_t q = 0; q < c.colliderPairCount; ++q) {
                const auto& p = impulses[base + q];
                const Vector3f at(p.x, p.y, p.z), r = state.positions[pairs[base + q].x];
                const Vector3f n = Vector3f(r.x(), r.y(), 0).normalized(), t(-n.y(), n.x(), 0);
                const Vector3f v = state.velocities[pairs[base + q].x];
                std::printf("  %u: w %.4f n %.4f t %.4f z %.4f kg, slide %.3g; v n %.5f t %.4f z %.5f\n", pairs[base + q].x, p.w / unit, at.dot(n) / unit,
                            at.dot(t) / unit, at.z() / unit, slides[base + q], v.dot(n), v.dot(t), v.z());
            }
        }
        if (2 * frame <= frames) out.between = out.moved;
    }
    return out;
}

}  // namespace knuckle::test
