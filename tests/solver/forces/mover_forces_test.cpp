#include "shared/force_types.h"
#include "sim/world/builder/parts/cloth.h"
#include "tests/solver/body/mover_fixture.h"

namespace knuckle::test {

namespace {

constexpr uint32_t SUBSTEP = 40;

ForceField fieldOf(FieldKind kind, FieldFalloff falloff, ColliderShape shape, Random& random)
{
    ForceField field{.kind = kind, .falloff = falloff, .region = {}, .strength = random.between(-9, 9)};
    field.region.shape = shape;
    field.region.position = random.inCube(1);
    field.region.orientation = random.rotation();
    field.region.halfExtents = {0.8f, 1.4f, 1.1f};
    field.region.radius = 1.3f;
    field.region.halfHeight = 0.7f;
    return field;
}

/// Fields of each kind in each shape, one before and one after its time, and gusts around all movers.
World windyWorld()
{
    WorldBuilder builder(DIAMETER / 2);
    builder.addMaterial({});
    Random random(5);
    for (const FieldKind kind : {FieldKind::Pull, FieldKind::Push, FieldKind::Swirl, FieldKind::Blow})
        for (const ColliderShape shape :
             {ColliderShape::Plane, ColliderShape::Box, ColliderShape::Sphere, ColliderShape::Capsule}) {
            const auto falloff = shape == ColliderShape::Plane    ? FieldFalloff::None
                                 : shape == ColliderShape::Sphere ? FieldFalloff::InverseSquare
                                                                  : FieldFalloff::Linear;
            builder.addForceField(fieldOf(kind, falloff, shape, random));
        }
    ForceField late = fieldOf(FieldKind::Push, FieldFalloff::None, ColliderShape::Sphere, random), early = late;
    late.start = 100.0f;
    early.stop = 0.01f;
    builder.addForceField(late);
    builder.addForceField(early);
    builder.setWind({.velocity = {5, 1, -3}, .density = 2.0f, .gusts = 0.5f, .gustSize = 0.7f, .seed = 3});
    for (uint32_t k = 0; k < 37; ++k) {
        builder.beginObject("box");
        builder.addBody("box", boxLattice({3, 2, 1}, DIAMETER), 0, k % 9 == 0 ? Motion::Fixed : Motion::Dynamic);
        builder.endObject({{static_cast<float>(k), 0, 0}, random.rotation()});
    }
    const ClothSpec spec;
    addCloth(builder, "cloth", gridSheet(0.9f, 0.7f, DIAMETER, spec), spec, std::vector<uint32_t>{0}, {});
    Particle grain;
    grain.mass = builder.particleMass(0);
    for (uint32_t k = 0; k < 51; ++k) {
        grain.position = {static_cast<float>(k), 5, 0};
        builder.addLooseParticle(grain);
    }
    return builder.build();
}

/// Compares mover_forces with sums in double precision.
class MoverForces : public testing::Test {
protected:
    MoverForces() : fixture(windyWorld())
    {
        Random random(6);
        BodyStage& bodies = fixture.stages.bodies;
        for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
            const Vector3f place = random.inCube(1.5f);
            const Quaternionf turn = fixture.isBody(m) ? random.rotation() : Quaternionf::Identity();
            centres.push_back({place.x(), place.y(), place.z(), 0});
            turns.push_back({turn.x(), turn.y(), turn.z(), turn.w()});
        }
        velocities = fixture.randomFields(4.0f, 3.0f, 7);
        bodies.moverCentres.upload(std::span<const gpu::vec4>(centres));
        bodies.moverRotations.upload(std::span<const gpu::vec4>(turns));
        bodies.moverVelocities.upload(std::span<const gpu::vec4>(velocities));
        for (size_t i = 0; i < fixture.world.particles.size(); ++i) positions.push_back(random.vec4(0.3f));
        fixture.stages.particles.positions.upload(std::span<const gpu::vec4>(positions));
        gpu::Counters counters = fixture.counters();
        counters.substep = SUBSTEP;
        fixture.setCounters(counters);
        fixture.forMovers("forces/mover_forces", {{"FORCES", "1"}, {"CLOTH", "1"}});
        found = fixture.stages.forces->moverAccelerations.download();
    }
    double h() const { return fixture.stages.parameters.substepTime; }

    Vector3d dragged(const Vector3d& wind, const Vector3d& drag) const
    {
        const Vector3d rate = wind.norm() * drag;
        return rate.cwiseProduct(wind).cwiseQuotient(Vector3d::Ones() + h() * rate);
    }
    Vector3d ofCloth(uint32_t particle, const Vector3d& wind) const
    {
        Vector3d sum = Vector3d::Zero();
        for (const auto& [a, b, c] : fixture.world.clothTriangles) {
            if (particle != a && particle != b && particle != c) continue;
            const Vector3d p = vec3(positions[a]).cast<double>();
            const Vector3d across =
                (vec3(positions[b]).cast<double>() - p).cross(vec3(positions[c]).cast<double>() - p);
            const double third = 0.5 * 2.0 * 0.5 * across.norm() / 3.0 /
                                 static_cast<double>(fixture.world.particles[particle].mass);
            const Vector3d normal = across.normalized(), head = wind.dot(normal) * normal;
            sum += dragged(head, Vector3d::Constant(PLATE_DRAG * third)) +
                   dragged(wind - head, Vector3d::Constant(SKIN_DRAG * third));
        }
        return sum;
    }

    MoverFixture fixture;
    std::vector<gpu::vec4> centres, turns, velocities, positions, found;
};

TEST_F(MoverForces, AreGravityFieldsAndTheAir)
{
    const World& world = fixture.world;
    const float now = SUBSTEP * fixture.stages.parameters.substepTime;
    const std::vector<GustWave> waves = gustWaves(*world.wind);
    const std::vector<Vector3f> drags = dragsOf(world);
    std::vector<uint32_t> loose;
    for (uint32_t i = 0; i < world.particles.size(); ++i)
        if (world.particles[i].body == NO_INDEX) loose.push_back(i);
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        Vector3d expected = world.settings.gravity.cast<double>();
        const Vector3f place = vec3(centres[m]) +
                               static_cast<float>(h()) * fixture.field(velocities, m).t.cast<float>();
        Vector3d wind = airVelocity(*world.wind, waves, place, now).cast<double>();
        Vector3d pulled = Vector3d::Zero();
        for (const ForceField& field : world.forceFields)
            if (now >= field.start && now < field.stop)
                (field.kind == FieldKind::Blow ? wind : pulled) += fieldAt(field, place).cast<double>();
        wind -= fixture.field(velocities, m).t;
        const gpu::vec4& q = turns[m];
        const Eigen::Quaterniond turn(q.w, q.x, q.y, q.z);
        const uint32_t particle = fixture.isBody(m) ? NO_INDEX : loose[m - world.bodies.size()];
        if (!fixture.isFixed(m)) {
            expected += pulled + turn * dragged(turn.conjugate() * wind, drags[m].cast<double>());
            if (particle != NO_INDEX) expected += ofCloth(particle, wind);
        }
        // Single precision: a cosine of up to 60 radians is off by 4e-6, wind and drag by as much; 1/r^2 at 0.05 m
        // multiplies an error of a place by 8000.
        EXPECT_LT((vec3(found[m]).cast<double>() - expected).norm(), 1e-3 * (10.0 + expected.norm())) << m;
    }
}

}  // namespace

}  // namespace knuckle::test
