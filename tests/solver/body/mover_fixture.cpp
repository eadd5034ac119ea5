#include "tests/solver/body/mover_fixture.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numeric>

namespace knuckle::test {

MoverFixture::MoverFixture(World worldIn) : KernelFixture(std::move(worldIn))
{
    findParts();
    Random random(81);
    for (uint32_t m = 0; m < moverCount(); ++m) {
        centres.push_back(packed(random.inCube(0.2f)));
        rotations.push_back(packed(isBody(m) ? random.rotation() : Quaternionf::Identity()));
    }
    fill(stages.bodies.moverCentres, centres);
    fill(stages.bodies.moverRotations, rotations);
    gpu::Counters now{};
    now.substep = SUBSTEP;
    now.listParity = 1;
    setCounters(now);
}

void MoverFixture::treatAllAsFree()
{
    std::vector<uint32_t> all(world.bodies.size());
    std::iota(all.begin(), all.end(), 0u);
    stages.bodies.bodyOrder = {"bodyOrder", std::span<const uint32_t>(all)};
    stages.parameters.freeBodyCount = static_cast<uint32_t>(all.size());
    stages.parameters.jointedBodyCount = 0;
    setParameters();
}

void MoverFixture::forFreeAndLoose(const std::string& kernel, const Defines& defines)
{
    run(kernel, stages.parameters.freeBodyCount, defines);
    run(kernel, moverCount() - stages.parameters.bodyCount, with(defines, "LOOSE"));
}

void MoverFixture::findParts()
{
    parts.resize(world.bodies.size());
    for (const Link& link : world.links)
        parts[link.body].push_back({link.particle, link.restOffset.cast<double>(), link.mass});
    for (uint32_t i = 0; i < world.particles.size(); ++i) {
        const Particle& p = world.particles[i];
        moverOf.push_back(p.body != NO_INDEX ? p.body : static_cast<uint32_t>(parts.size()));
        if (p.body == NO_INDEX) parts.push_back({{i, Vector3d::Zero(), p.mass}});
    }
    for (const auto& list : parts) {
        masses.push_back(0.0);
        for (const Part& part : list) masses.back() += part.mass;
    }
}

double MoverFixture::radius(uint32_t mover) const
{
    double largest = 0.0;
    for (const Part& part : parts[mover]) largest = std::max(largest, part.r.norm());
    return largest;
}

uint32_t MoverFixture::fieldStart(uint32_t mover) const
{
    const auto bodies = static_cast<uint32_t>(world.bodies.size());
    return mover < bodies ? 4 * mover : 3 * bodies + mover;
}

Field MoverFixture::field(const std::vector<gpu::vec4>& fields, uint32_t mover) const
{
    const uint32_t start = fieldStart(mover);
    Field field;
    field.t = vec3(fields[start]).cast<double>();
    for (uint32_t c = 0; isBody(mover) && c < 3; ++c) field.f.col(c) = vec3(fields[start + 1 + c]).cast<double>();
    return field;
}

std::vector<gpu::vec4> MoverFixture::randomFields(float ofT, float ofF, uint32_t seed) const
{
    Random random(seed);
    std::vector<gpu::vec4> fields(stages.bodies.moverVelocities.size());
    for (uint32_t m = 0; m < moverCount(); ++m) {
        fields[fieldStart(m)] = random.vec4(ofT);
        for (uint32_t c = 1; isBody(m) && c <= 3; ++c) fields[fieldStart(m) + c] = random.vec4(ofF);
    }
    return fields;
}

std::vector<gpu::vec4> MoverFixture::randomImpulses(float move, uint32_t seed) const
{
    Random random(seed);
    std::vector<gpu::vec4> fields(stages.bodies.moverVelocities.size());
    for (uint32_t m = 0; m < moverCount(); ++m) {
        Field sum;
        for (int k = 0; k < 3; ++k) {
            const size_t last = parts[m].size() - 1;
            const auto pick = static_cast<size_t>(random.between(0, 1) * static_cast<float>(parts[m].size()));
            sum.add(masses[m] * random.inCube(move).cast<double>(), parts[m][std::min(pick, last)].r);
        }
        fields[fieldStart(m)] = packed(Vector3f(sum.t.cast<float>()));
        for (uint32_t c = 0; isBody(m) && c < 3; ++c)
            fields[fieldStart(m) + 1 + c] = packed(Vector3f(sum.f.col(c).cast<float>()));
    }
    return fields;
}

void MoverFixture::setMoves(float move, float angle, float w)
{
    Random random(82);
    moves.clear();
    turns.clear();
    for (uint32_t m = 0; m < moverCount(); ++m) {
        moves.push_back(packed(random.inCube(move), w));
        const Quaternionf turn(Eigen::AngleAxisf(random.between(0, angle), random.direction()));
        turns.push_back(packed(isBody(m) ? turn : Quaternionf::Identity()));
    }
    fill(stages.bodies.moverMoves, moves);
    fill(stages.bodies.moverRotationDeltas, turns);
}

void MoverFixture::setAssemblies(uint32_t lastContact, uint32_t order)
{
    fill(stages.particles.assemblyState,
         std::vector<gpu::uvec2>(stages.particles.assemblyState.size(), {lastContact, order}));
}

Vector3d MoverFixture::moveOf(uint32_t mover, const Vector3d& r) const
{
    const Vector3d from = arm(mover, r);
    return vec3(moves[mover]).cast<double>() + quaternion(turns[mover]).cast<double>() * from - from;
}

Eigen::Quaterniond nearestRotation(const Matrix3d& a)
{
    const Vector3d v(a(2, 1) - a(1, 2), a(0, 2) - a(2, 0), a(1, 0) - a(0, 1));
    Eigen::Matrix4d k;
    k << a + a.transpose() - a.trace() * Matrix3d::Identity(), v, v.transpose(), a.trace();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(k);
    return Eigen::Quaterniond(Eigen::Vector4d(eigen.eigenvectors().col(3)));  // xyzw
}

double rotationError(const Eigen::Quaterniond& found, const Matrix3d& a, const Matrix3d& moments)
{
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(moments);  // ascending
    const Vector3d& values = eigen.eigenvalues();
    if (values[2] < 1e-12) return 0.0;
    if (values[1] > 1e-6 * values[2]) return found.angularDistance(nearestRotation(a));
    const Vector3d line = eigen.eigenvectors().col(2);
    return (found.normalized() * line - (a * line).normalized()).norm();
}

}  // namespace knuckle::test
