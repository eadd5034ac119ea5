#pragma once

#include "tests/solver/body/mover_fixture.h"

namespace knuckle::test {

/// A contact of a particle with another or with a collider, in the kernels' terms.
struct TestContact {
    uint32_t first = 0, second = 0;  ///< Particles; the second may be a collider.
    Vector3f firstArm{0, 0, 0}, secondArm{0, 0, 0};
    float firstMass = 0, secondMass = 0;            ///< Worst inverse masses, 0: fixed [1/kg].
    float firstFraction = 1, secondFraction = 1;    ///< Of them along the normal; of pairs multiples of 1/8191,
                                                    ///< with colliders of 1/65535.
    float staticFriction = 0, kineticFriction = 0;  ///< Halves.
    uint32_t hidden = 0;            ///< Axes of the bodies along which their lattices continue, three bits each.
    bool kin = false;               ///< Both particles belong to one assembly, as the lists say.
    gpu::vec4 impulse{0, 0, 0, 0};  ///< Before the kernel runs.
    float mean = 0;                 ///< Of its normal part.
};

/// mixedWorld with a plane and a sphere.
World worldWithColliders(const Settings& settings = {});

/// Movers with arbitrary contacts in the lists, which need not be near each other.
class ContactFixture : public MoverFixture {
public:
    /// With a plane and a sphere.
    explicit ContactFixture(const Settings& settings = {});
    explicit ContactFixture(World worldIn);

    /// Puts the contacts into the lists of the second half, each at its place by rank.
    void setPairs(std::vector<TestContact> contacts);
    void setColliderContacts(std::vector<TestContact> contacts);
    std::vector<gpu::vec4> pairImpulses() const { return secondHalf(stages.contacts.pairImpulses, pairs.size()); }
    std::vector<float> pairMeans() const { return secondHalf(stages.contacts.pairMeans, pairs.size()); }
    std::vector<gpu::vec4> colliderImpulses() const
    {
        return secondHalf(stages.contacts.colliderImpulses, colliderContacts.size());
    }
    std::vector<float> colliderMeans() const
    {
        return secondHalf(stages.contacts.colliderMeans, colliderContacts.size());
    }
    Vector3d place(uint32_t particle, const Vector3f& arm) const
    {
        return centre(moverOf[particle]) + this->arm(moverOf[particle], arm.cast<double>());
    }
    Vector3d moveOfArm(uint32_t particle, const Vector3f& arm) const
    {
        return moveOf(moverOf[particle], arm.cast<double>());
    }
    /// The arm for which a particle's mover has `place` at the start of the substep.
    Vector3f armTo(uint32_t particle, const Vector3f& place) const;

    std::vector<TestContact> pairs, colliderContacts;  ///< In the order of the lists.
    std::vector<uint32_t> rankOf;                      ///< Per particle.

private:
    template <typename Value>
    static std::vector<Value> secondHalf(const Buffer<Value>& buffer, size_t count)
    {
        std::vector<Value> values(count);
        buffer.read(values.data(), count * sizeof(Value), buffer.size() / 2 * sizeof(Value));
        return values;
    }
    /// By the rank of the first particle.
    std::vector<TestContact> inOrder(std::vector<TestContact> contacts) const;
    void setLists();
};

}  // namespace knuckle::test
