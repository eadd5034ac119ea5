#include <Eigen/Dense>
#include <algorithm>
#include <bit>

#include "sim/world/builder/parts/cloth.h"
#include "sim/world/builder/parts/rope.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

/// A cube on a rope that may tear, one that hangs between two cubes, a free one, and a cloth that is held at a corner
/// and tied to a cube: strands that cross, and ends of every kind.
World ropeWorld()
{
    WorldBuilder builder(DIAMETER / 2);
    Material material;
    material.density = 3000.0f;
    builder.addMaterial(material);
    uint32_t cubes[3];
    for (uint32_t k = 0; k < 3; ++k) {
        builder.beginObject("cube");
        const uint32_t body = builder.addBody("cube", boxLattice({3, 3, 3}, DIAMETER), 0);
        builder.endObject({Vector3f(static_cast<float>(k), -1, 0)});
        cubes[k] = builder.ownParticles(body)[2];
    }
    const auto at = [&](uint32_t particle) { return builder.world().particles[particle].position; };
    RopeSpec rope;
    rope.from = {0, 0.2f, 0};
    rope.to = at(cubes[0]);
    rope.start.kind = RopeEnd::Kind::Fixed;
    rope.end = {RopeEnd::Kind::Attached, cubes[0]};
    rope.tearForce = 800.0f;
    addRope(builder, "hangs", rope);
    RopeSpec between;
    between.from = at(cubes[0]);
    between.to = at(cubes[1]);
    between.start = {RopeEnd::Kind::Attached, cubes[0]};
    between.end = {RopeEnd::Kind::Attached, cubes[1]};
    between.compliance = 1e-5f;
    addRope(builder, "between", between);
    RopeSpec ahead;
    ahead.from = {0, 2, 0};
    ahead.to = {1.3f, 2, 0};
    ahead.end.kind = RopeEnd::Kind::Fixed;
    ahead.bendCompliance = 1e-3f;
    addRope(builder, "held at its end", ahead);
    ClothSpec spec;
    spec.bendCompliance = 1e-2f;
    const ClothSheet sheet = gridSheet(0.6f, 0.4f, DIAMETER, spec);
    const Pose pose{at(cubes[2]) + Vector3f(0, 0.08f, 0) - sheet.nodes[0]};
    const std::vector<uint32_t> held = {static_cast<uint32_t>(sheet.nodes.size()) - 1};
    const std::vector<ClothTie> ties = {{0, cubes[2]}};
    addCloth(builder, "cloth", sheet, spec, held, ties, pose);
    return builder.build();
}

/// One Newton step of a row by all its equations at once, in double precision.
struct Wanted {
    std::vector<Vector3d> pushes;   ///< Per node, the impulse on it [kg m].
    std::vector<gpu::vec4> states;  ///< Per link.
};

class DistanceSolve : public testing::TestWithParam<bool> {
protected:
    DistanceSolve() : fixture(ropeWorld())
    {
        Random random(77);
        Stages& b = fixture.stages;
        moves = b.bodies.moverMoves.download();
        turns = b.bodies.moverRotationDeltas.download();
        for (uint32_t m = 0; m < moves.size(); ++m) {
            moves[m] = packed(random.inCube(0.1f * DIAMETER), 1.0f);
            const Vector3f half = random.inCube(0.02f);
            if (m < fixture.world.bodies.size()) turns[m] = packed(half, std::sqrt(1.0f - half.squaredNorm()));
        }
        fill(b.bodies.moverMoves, moves);
        fill(b.bodies.moverRotationDeltas, turns);
        states = b.strands->distanceStates.download();
        for (gpu::vec4& s : states)
            s = {random.between(-1e-3f, 1e-3f), random.between(-400, 1000), random.between(0, 1) < 0.05f ? 1.0f : 0.0f,
                 0};
        fill(b.strands->distanceStates, states);
        nodes = b.strands->distanceNodes.download();
        links = b.strands->distanceLinks.download();
        centres = b.bodies.moverCentres.download();
        rotations = b.bodies.moverRotations.download();
        offsets = b.particles.restOffsets.download();
        inertias = b.bodies.bodyInertias.download();
        auto orders = b.particles.assemblyState.download();
        for (size_t a = 0; a < orders.size(); a += 2) orders[a].y = 2;
        fill(b.particles.assemblyState, orders);
        assemblies = orders;
    }

    /// The solver's value for its inverse mass; 0: nothing moves it.
    double share(uint32_t node) const
    {
        const bool fixed = isBody(node) && fixture.world.bodies[nodes[node].x].motion == Motion::Fixed;
        return fixed ? 0.0 : static_cast<double>(std::bit_cast<float>(nodes[node].w));
    }
    bool isBody(uint32_t node) const { return nodes[node].x < fixture.world.bodies.size(); }
    Vector3d arm(uint32_t node) const
    {
        if (!isBody(node)) return Vector3d::Zero();
        return quaternion(rotations[nodes[node].x]).cast<double>() * vec3(offsets[nodes[node].z]).cast<double>();
    }
    Vector3d place(uint32_t node) const
    {
        const uint32_t m = nodes[node].x;
        const Vector3d turned = isBody(node) ? Vector3d(quaternion(turns[m]).cast<double>() * arm(node)) : arm(node);
        return vec3(centres[m]).cast<double>() + vec3(moves[m]).cast<double>() + turned;
    }
    /// The move of a node by an impulse [1/kg].
    Matrix3d response(uint32_t node) const
    {
        const uint32_t m = nodes[node].x;
        if (!isBody(node)) return share(node) * Matrix3d::Identity();
        const gpu::vec4 &diagonal = inertias[2 * m], &other = inertias[2 * m + 1];
        Matrix3d inverse;
        inverse << diagonal.x, other.x, other.y, other.x, diagonal.y, other.z, other.y, other.z, diagonal.z;
        const Matrix3d axes = quaternion(rotations[m]).cast<double>().toRotationMatrix();
        const Vector3d r = arm(node);
        Matrix3d cross;
        cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
        const Matrix3d turning = cross.transpose() * axes * inverse * axes.transpose() * cross;
        return share(node) * (static_cast<double>(diagonal.w) * Matrix3d::Identity() + turning);
    }

    /// M dx = sum of pulls; n (dx_b - dx_a) + (alpha + regular) dλ = rest - length - alpha λ, where the pull of a link
    /// is dλ n - k (1 - n n^T) (dx_b - dx_a).
    Wanted wanted(const gpu::uvec4& distances) const
    {
        const uint32_t first = distances.x, count = distances.y - distances.x + 1;
        const double h = static_cast<double>(fixture.stages.parameters.substepTime);
        const double squared = (assemblies[distances.z].y == 2 ? 4.0 / 9.0 : 1.0) * h * h;
        const Eigen::Index size = 4 * count - 1;
        Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size);
        Eigen::VectorXd b = Eigen::VectorXd::Zero(size);
        std::vector<Matrix3d> responses;
        for (uint32_t k = 0; k < count; ++k) {
            responses.push_back(response(first + k));
            a.block<3, 3>(3 * k, 3 * k).setIdentity();
        }
        Wanted out;
        std::vector<Vector3d> normals;
        std::vector<Matrix3d> turnings;
        for (uint32_t k = 0; k + 1 < count; ++k) {
            gpu::vec4 state = states[first + k];
            const gpu::vec4& link = links[first + k];
            const Vector3d apart = place(first + k + 1) - place(first + k), n = apart.normalized();
            const double far = apart.norm(), compliance = static_cast<double>(link.y) / squared;
            if (GetParam()) {
                if (state.y > link.z || far > static_cast<double>(link.w)) state.z = 1.0f;
                state.x = 0.0f;
            }
            const double both = n.dot((responses[k] + responses[k + 1]) * n);
            const double turning = std::min(std::max(double(state.y), 0.0) * squared / far,
                                            30.0 / std::max(both, 1e-20));
            const double regular = (share(first + k + 1) == 0.0 ? 1e-3 : 1e-5) * both;
            const bool none = state.z != 0.0f || both == 0.0;
            const Matrix3d across = none ? Matrix3d(Matrix3d::Zero())
                                         : Matrix3d(turning * (Matrix3d::Identity() - n * n.transpose()));
            normals.push_back(n);
            turnings.push_back(across);
            out.states.push_back(state);
            const Eigen::Index row = 3 * count + k, ia = 3 * k, ib = ia + 3;
            // dx - W (sum of pulls) = 0, in units of moves.
            for (const auto& [node, sign] : {std::pair{ia, -1.0}, std::pair{ib, 1.0}}) {
                const Matrix3d& w = responses[static_cast<size_t>(node / 3)];
                a.block<3, 1>(node, row) -= sign * w * n * (none ? 0.0 : 1.0);
                a.block<3, 3>(node, ib) += sign * w * across;
                a.block<3, 3>(node, ia) -= sign * w * across;
            }
            if (none) {
                a(row, row) = 1.0;
                continue;
            }
            a.block<1, 3>(row, ib) = n.transpose();
            a.block<1, 3>(row, ia) = -n.transpose();
            a(row, row) = compliance + regular;
            b(row) = static_cast<double>(link.x) - far - compliance * static_cast<double>(state.x);
        }
        const Eigen::VectorXd x = a.fullPivLu().solve(b);
        out.pushes.assign(count, Vector3d::Zero());
        for (uint32_t k = 0; k + 1 < count; ++k) {
            const double change = x(3 * count + k);
            const Vector3d moved = x.segment<3>(3 * k + 3) - x.segment<3>(3 * k);
            const Vector3d pull = change * normals[k] - turnings[k] * moved;
            out.pushes[k] -= pull;
            out.pushes[k + 1] += pull;
            out.states[k].x = static_cast<float>(double(out.states[k].x) + change);
            out.states[k].y = static_cast<float>(-double(out.states[k].x) / squared);
        }
        return out;
    }

    KernelFixture fixture;
    std::vector<gpu::vec4> moves, turns, states, links, centres, rotations, offsets, inertias;
    std::vector<gpu::uvec4> nodes;
    std::vector<gpu::uvec2> assemblies;
};

TEST_P(DistanceSolve, ARowIsSolvedAsAllItsEquationsAtOnce)
{
    Stages& b = fixture.stages;
    const auto strands = b.strands->strands.download();
    uint32_t torn = 0, bodies = 0;
    ASSERT_GT(b.strands->colors().size(), 2u);
    for (const StrandStage::Color& color : b.strands->colors()) {
        Defines defines;
        if (GetParam()) defines.push_back({"FIRST_ITERATION", "1"});
        if (color.hasBodies) defines.push_back({"BODIES", "1"});
        if (b.strands->isHeavy()) defines.push_back({"HEAVY", "1"});
        const auto impulsesBefore = b.bodies.particleImpulses.download();
        const Kernel kernel = fixture.load("strand/strand_solve", defines);
        glProgramUniform2ui(kernel.program(), 0, color.begin, color.end);
        fixture.dispatch(kernel, (color.end - color.begin + DISTANCE_GROUP_SIZE - 1) / DISTANCE_GROUP_SIZE);
        gpu().checkErrors();
        const auto impulses = b.bodies.particleImpulses.download(), movesNow = b.bodies.moverMoves.download();
        const auto statesNow = b.strands->distanceStates.download();
        for (uint32_t s = color.begin; s < color.end; ++s) {
            SCOPED_TRACE("row " + std::to_string(s));
            const Wanted w = wanted(strands[s]);
            double size = 0.0;
            for (const Vector3d& p : w.pushes) size = std::max(size, p.norm());
            // Single precision: eliminating links that are 1e5 times stiffer along than their regularization loses a
            // few of seven digits.
            const double tolerance = 1e-3 * size + 1e-9;
            for (uint32_t k = strands[s].x; k <= strands[s].y; ++k) {
                const Vector3d& p = w.pushes[k - strands[s].x];
                const uint32_t m = nodes[k].x, rank = nodes[k].y;
                const Vector3d found = (vec3(impulses[rank]) - vec3(impulsesBefore[rank])).cast<double>();
                const Vector3d moved = (vec3(movesNow[m]) - vec3(moves[m])).cast<double>();
                EXPECT_LE((found - (share(k) == 0.0 ? 0.0 : 1.0) * p).norm(), tolerance) << "node " << k;
                EXPECT_LE((moved - (isBody(k) ? 0.0 : share(k)) * found).norm(), 1e-7) << "node " << k;
                bodies += isBody(k) && share(k) != 0.0;
                if (k == strands[s].y) continue;
                const gpu::vec4& state = w.states[k - strands[s].x];
                EXPECT_NEAR(statesNow[k].x, state.x, tolerance);
                EXPECT_EQ(statesNow[k].z, state.z);
                torn += state.z != 0.0f;
            }
        }
        moves = movesNow;
    }
    EXPECT_GT(torn, 3u);
    EXPECT_GT(bodies, 3u);
}

INSTANTIATE_TEST_SUITE_P(Iterations, DistanceSolve, testing::Bool(),
                         [](const auto& first) { return first.param ? "First" : "Later"; });

}  // namespace

}  // namespace knuckle::test
