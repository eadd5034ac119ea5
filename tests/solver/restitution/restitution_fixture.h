#pragma once

#include <array>

#include "shared/contact_constants.h"
#include "tests/solver/contact/contact_fixture.h"

namespace knuckle::test {

/// Motion of a mover, in double precision.
struct Velocity {
    Vector3d t = Vector3d::Zero();     ///< Of its centre [m/s].
    Vector3d spin = Vector3d::Zero();  ///< [rad/s]

    Vector3d at(const Vector3d& arm) const { return t + spin.cross(arm); }
    double size(const Vector3d& arm) const { return t.norm() + spin.norm() * arm.norm(); }
};

/// One velocity per mover, in the forms of the host and of the shaders.
struct Velocities {
    std::vector<Velocity> known;
    std::vector<gpu::vec4> fields;
};

/// How a contact's two sides meet and move along its normal, with bounds of the error of single precision.
struct Collision {
    Vector3d normal;
    double approach = 0.0, now = 0.0, solved = 0.0;  ///< [m/s]
    double approachError = 0.0, speedError = 0.0;    ///< [m/s]
    double turnError = 0.0;                          ///< Of the normal.
    bool sure = true;                                ///< Not so near to a limit that rounding decides.
};

/// Movers in the middle of collisions: 1501 contacts between particles and 777 with colliders, with random inputs for
/// the kernels of restitution. Fixed movers have no velocity.
class RestitutionFixture : public ContactFixture {
public:
    RestitutionFixture();

    double h() const { return stages.parameters.substepTime; }
    Vector3d gravity() const { return vec3(stages.parameters.gravity).cast<double>(); }
    bool responds(uint32_t mover) const { return !isFixed(mover); }
    /// The arm of a mover's point at a contact.
    Vector3d armOf(uint32_t mover, const Vector3f& r) const { return arm(mover, r.cast<double>()); }
    Collision ofPair(const TestContact& c) const;
    Collision ofCollider(const TestContact& c) const;
    /// The impulses so far: a third none, a third pending, a third non-zero.
    void setRestitutions(uint32_t seed);

    std::vector<gpu::vec4> pairRestitutions() const;
    std::vector<gpu::vec4> colliderRestitutions() const;
    double restitution(uint32_t particle) const { return masses_[particle].y; }

    Velocities before, solved, now;                   ///< The substep, after its solve, and with what bounced since.
    std::vector<gpu::vec4> ways;                      ///< oldMoverMoves.
    std::vector<float> splits;                        ///< moverRestitutionSplits.
    std::vector<gpu::vec4> shares;                    ///< moverRestitutionShares.
    std::vector<gpu::vec4> lastPairs, lastColliders;  ///< Restitutions before the kernel, in the order of the lists.

private:
    Velocities randomVelocities(float ofT, float ofSpin, uint32_t seed) const;
    void makePairs();
    void makeColliderContacts();
    void addState(TestContact& c, Random& random, float levels) const;
    Vector3d particleArm(uint32_t particle) const;
    /// Adds one side's part in the direction of the normal, and its errors.
    void addSide(Collision& out, uint32_t mover, const Vector3f& r, double sign, Vector3d& arrival, Vector3d& way,
                 Vector3d& pull) const;
    void finish(Collision& out, const Vector3d& arrival, const Vector3d& way, const Vector3d& pull) const;

    std::vector<gpu::vec4> masses_, offsets_;
};

/// The expected impulse after a kernel, and its tolerance.
struct Bounce {
    Vector3d whole = Vector3d::Zero();
    double w = 0.0;
    double tolerance = 0.0;
    bool sure = true;
};

/// The reference of solveRestitution. @param inverseMass of both sides, split.
Bounce bounceOf(const Collision& c, const gpu::vec4& last, double restitution, double inverseMass, bool eager);

/// Compares impulses one by one; `wanted` gets the index of each.
template <typename Wanted>
void expectBounces(const std::vector<gpu::vec4>& found, const Wanted& wanted)
{
    uint32_t edges = 0, nothing = 0, waiting = 0, acting = 0;
    for (size_t q = 0; q < found.size(); ++q) {
        const Bounce b = wanted(q);
        if (!b.sure && ++edges) continue;
        ASSERT_NEAR(found[q].w, b.w, b.tolerance) << "contact " << q;
        ASSERT_LE((vec3(found[q]).cast<double>() - b.whole).norm(), 3 * b.tolerance) << "contact " << q;
        ++(b.w == 0.0 ? nothing : b.w < 0.0 ? waiting : acting);
    }
    // Every case occurs more than a few times.
    for (uint32_t met : {nothing, waiting, acting}) EXPECT_GT(met, found.size() / 20);
    EXPECT_LT(edges, found.size() / 50);
}

class Restitution : public testing::Test {
protected:
    /// After DETECT: contacts that meet fast while they carry are about to act, and no others. @param collisionOf,
    /// restitutionOf a contact. @param enough the least number that act, and that carry but are too slow.
    template <typename CollisionOf, typename RestitutionOf>
    void expectDetection(const std::vector<gpu::vec4>& found, const std::vector<TestContact>& contacts,
                         const CollisionOf& collisionOf, const RestitutionOf& restitutionOf, uint32_t enough)
    {
        const double least = fixture.stages.parameters.restitutionThreshold;
        uint32_t acting = 0, slow = 0, edges = 0;
        for (size_t q = 0; q < found.size(); ++q) {
            const TestContact& c = contacts[q];
            const Collision s = collisionOf(c);
            if (std::abs(s.approach - least) < s.approachError || (!s.sure && s.approach < 0.1)) {
                ++edges;
                continue;
            }
            const bool carries = restitutionOf(c) > 0.0 && c.impulse.w > 0.0f, acts = carries && s.approach > least;
            ASSERT_EQ(found[q].w, acts ? ABOUT_TO_ACT : 0.0f) << "contact " << q;
            ASSERT_EQ(vec3(found[q]), Vector3f(0, 0, 0)) << "contact " << q;
            acting += acts;
            slow += carries && !acts;
        }
        EXPECT_GT(acting, enough);
        EXPECT_GT(slow, enough);
        EXPECT_LT(edges, found.size() / 50);
    }

    RestitutionFixture fixture;
};

}  // namespace knuckle::test
