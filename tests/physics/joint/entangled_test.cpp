#include <algorithm>
#include <cmath>
#include <random>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

constexpr uint32_t FIGURES = 50, ROW = 10, BODIES = 9;

/// A torso with two arms and two legs, of two bodies each: balls at the torso, hinges at elbows and knees.
/// @param anchors gets the places of joints of each body, from its middle [m].
void addFigure(WorldBuilder& builder, const Vector3f& place, std::vector<Vector3f>& anchors)
{
    builder.beginObject("figure");
    const uint32_t torso = builder.addBody("torso", boxLattice({3, 5, 3}, DIAMETER), 0);
    anchors.emplace_back(0, 0, 0);
    const auto limb = [&](const Vector3f& root, const Vector3f& along) {
        uint32_t parent = torso;
        for (const float start : {0.0f, 4.0f}) {
            std::vector<Vector3f> places;
            for (int k = 0; k < 3; ++k)
                for (const float side : {0.0f, 1.0f})
                    places.push_back(DIAMETER * (root + (start + 1.0f + static_cast<float>(k)) * along +
                                                 Vector3f(0, 0, side - 0.5f)));
            const uint32_t body = builder.addBody("limb", places, 0);
            JointSpec joint;
            joint.type = start == 0.0f ? JointType::Ball : JointType::Hinge;
            joint.anchor = DIAMETER * (root + start * along);
            joint.along = along;
            builder.addJoint(parent, body, joint);
            anchors.push_back(joint.anchor);
            parent = body;
        }
    };
    for (const float side : {-1.0f, 1.0f}) {
        limb({2 * side, 2, 0}, {side, 0, 0});
        limb({side, -3, 0}, {0, -1, 0});
    }
    builder.endObject({place, Quaternionf::Identity()});
}

/// Turns everything that hangs on a joint about it. Hinges turn about z.
void fold(World& world, uint32_t figure, const std::vector<Vector3f>& anchors, std::mt19937& random)
{
    const auto any = [&] { return static_cast<float>(random()) / 2147483648.0f - 1.0f; };
    struct Turn {
        Quaternionf rotation = Quaternionf::Identity();
        Vector3f shift{0, 0, 0};
    };
    std::vector<Turn> turns(BODIES);
    const Vector3f origin = world.bodies[figure * BODIES].position;
    for (uint32_t b = 0; b < BODIES; ++b) {
        const uint32_t parent = b == 0 || b % 2 == 1 ? 0 : b - 1;
        const float angle = static_cast<float>(M_PI) * any();
        const Vector3f axis = b > 0 && b % 2 == 0 ? Vector3f(0, 0, 1)
                                                  : Vector3f(any(), any(), any() + 0.01f).normalized();
        const Turn up = turns[parent];
        const Vector3f anchor = origin + anchors[figure * BODIES + b];
        turns[b].rotation = up.rotation * Eigen::AngleAxisf(angle, axis);
        turns[b].shift = up.rotation * anchor + up.shift - turns[b].rotation * anchor;
        Body& body = world.bodies[figure * BODIES + b];
        body.position = turns[b].rotation * body.position + turns[b].shift;
        body.rotation = turns[b].rotation * body.rotation;
    }
    for (const Link& link : world.links) {
        const Body& body = world.bodies[link.body];
        if (link.body / BODIES == figure)
            world.particles[link.particle].position = body.position + body.rotation * link.restOffset;
    }
}

/// Kinetic and gravitational energy of each figure [J].
std::vector<double> energies(const World& world, const ParticleState& state)
{
    std::vector<double> sums(FIGURES, 0.0);
    for (size_t i = 0; i < world.particles.size(); ++i) {
        const double m = world.particles[i].mass;
        sums[world.particles[i].body / BODIES] += 0.5 * m * state.velocities[i].cast<double>().squaredNorm() +
                                                  m * GRAVITY * state.positions[i].y();
    }
    return sums;
}

}  // namespace

/// Figures randomly folded into themselves, most with limbs through limbs and through the torso: their entanglement
/// gives them no energy, and they come to rest.
TEST(Entangled, FiguresComeToRest)
{
    WorldBuilder builder = makeBuilder();
    builder.addCollider(floorPlane());
    std::vector<Vector3f> anchors;
    for (uint32_t k = 0; k < FIGURES; ++k)
        addFigure(builder, {3.0f * static_cast<float>(k % ROW), 1.3f, 3.0f * static_cast<float>(k / ROW)}, anchors);
    World world = builder.build();
    std::mt19937 random(7);
    for (uint32_t k = 0; k < FIGURES; ++k) fold(world, k, anchors, random);
    Solver solver(gpu(), world);
    std::vector<double> least = energies(world, solver.readParticles()), rise(FIGURES, 0.0);
    double mass = 0.0;
    for (const Particle& p : world.particles) mass += p.mass / FIGURES;
    for (int i = 0; i < 50; ++i) {
        run(solver, world, 0.1);
        const std::vector<double> now = energies(world, solver.readParticles());
        for (uint32_t k = 0; k < FIGURES; ++k) {
            least[k] = std::min(least[k], now[k]);
            rise[k] = std::max(rise[k], now[k] - least[k]);
        }
    }
    double fastest = 0.0, sum = 0.0;
    for (const BodyState& body : solver.readBodies()) {
        fastest = std::max<double>(fastest, body.velocity.norm());
        sum += body.velocity.norm();
    }
    const double most = *std::max_element(rise.begin(), rise.end());
    EXPECT_LT(most, 0.01 * mass * GRAVITY * 1.3);  // measured 0.006
    EXPECT_LT(fastest, 1.0);                       // measured 0.6: one whose limbs are still coming apart
    EXPECT_LT(sum / static_cast<double>(world.bodies.size()), 0.02);
}

}  // namespace knuckle::test
