#include "tests/solver/contact/contact_fixture.h"

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "tests/solver/contact/collider_world.h"

namespace knuckle::test {

namespace {

constexpr uint32_t PARITY = 1;
constexpr uint32_t KIN = 1u << 23;  // shaders/sim/common/contacts/one_sided.glsl

uint32_t packHalves(float a, float b)
{
    const auto bits = [](float v) { return uint32_t(std::bit_cast<uint16_t>(Eigen::half(v))); };
    return bits(a) | bits(b) << 16;
}

uint32_t level(float share, float levels)
{
    return static_cast<uint32_t>(std::lround(share * levels));
}

template <typename T>
void put(Buffer<T>& buffer, const std::vector<T>& values, size_t start = 0)
{
    buffer.write(values.data(), values.size() * sizeof(T), start * sizeof(T));
}

}  // namespace

World worldWithColliders(const Settings& settings)
{
    World world = mixedWorld(settings);
    const Quaternionf tilt(Eigen::AngleAxisf(0.4f, Vector3f(1, 0, 0)));
    world.colliders = {colliderOf(ColliderShape::Plane, {0, 0, 0}, tilt),
                       colliderOf(ColliderShape::Sphere, {0.1f, -0.2f, 0.3f})};
    return world;
}

ContactFixture::ContactFixture(const Settings& settings) : ContactFixture(worldWithColliders(settings)) {}

ContactFixture::ContactFixture(World worldIn) : MoverFixture(std::move(worldIn))
{
    std::vector<uint32_t> order(moverOf.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return moverOf[a] < moverOf[b]; });
    rankOf.resize(order.size());
    for (uint32_t rank = 0; rank < order.size(); ++rank) rankOf[order[rank]] = rank;
}

Vector3f ContactFixture::armTo(uint32_t particle, const Vector3f& place) const
{
    const uint32_t m = moverOf[particle];
    return quaternion(rotations[m]).conjugate() * (place - vec3(centres[m]));
}

std::vector<TestContact> ContactFixture::inOrder(std::vector<TestContact> contacts) const
{
    std::stable_sort(contacts.begin(), contacts.end(),
                     [&](const TestContact& a, const TestContact& b) { return rankOf[a.first] < rankOf[b.first]; });
    return contacts;
}

void ContactFixture::setPairs(std::vector<TestContact> contacts)
{
    pairs = inOrder(std::move(contacts));
    std::vector<gpu::uvec4> sides;
    std::vector<gpu::vec4> arms, impulses;
    std::vector<float> means;
    for (const TestContact& c : pairs) {
        const uint32_t first = moverOf[c.first] | (c.kin ? KIN : 0u);
        sides.push_back({first, moverOf[c.second], packHalves(c.staticFriction, c.kineticFriction),
                         level(c.firstFraction, 8191) | level(c.secondFraction, 8191) << 13 | c.hidden << 26});
        arms.push_back(packed(c.firstArm, c.firstMass));
        arms.push_back(packed(c.secondArm, c.secondMass));
        impulses.push_back(c.impulse);
        means.push_back(c.mean);
    }
    put(stages.contacts.pairSides, sides);
    put(stages.contacts.pairArms, arms);
    put(stages.contacts.pairImpulses, impulses, PARITY * stages.parameters.pairCapacity);
    put(stages.contacts.pairMeans, means, PARITY * stages.parameters.pairCapacity);
    setLists();
}

void ContactFixture::setColliderContacts(std::vector<TestContact> contacts)
{
    colliderContacts = inOrder(std::move(contacts));
    std::vector<gpu::uvec4> sides;
    std::vector<gpu::vec4> arms, impulses;
    std::vector<float> means;
    std::vector<gpu::uvec2> found;
    for (const TestContact& c : colliderContacts) {
        sides.push_back({moverOf[c.first], c.second, packHalves(c.staticFriction, c.kineticFriction),
                         level(c.firstFraction, 65535) | 0xffffu << 16});
        arms.push_back(packed(c.firstArm, c.firstMass));
        impulses.push_back(c.impulse);
        means.push_back(c.mean);
        found.push_back({c.first, c.second});
    }
    put(stages.search.colliderPairs, found, PARITY * stages.parameters.colliderPairCapacity);
    put(stages.contacts.colliderSides, sides);
    put(stages.contacts.colliderArms, arms);
    put(stages.contacts.colliderImpulses, impulses, PARITY * stages.parameters.colliderPairCapacity);
    put(stages.contacts.colliderMeans, means, PARITY * stages.parameters.colliderPairCapacity);
    setLists();
}

/// Sets the starts of each rank's lists (shaders/sim/common/contacts/contact_lists.glsl), and the references of second
/// particles.
void ContactFixture::setLists()
{
    const size_t count = rankOf.size();
    std::vector<uint32_t> starts(3 * count + 1), references(pairs.size());
    for (const TestContact& c : pairs) {
        ++starts[rankOf[c.first] + 1];
        ++starts[count + rankOf[c.second] + 1];
    }
    for (const TestContact& c : colliderContacts) ++starts[2 * count + rankOf[c.first] + 1];
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    std::iota(references.begin(), references.end(), 0u);
    std::stable_sort(references.begin(), references.end(),
                     [&](uint32_t a, uint32_t b) { return rankOf[pairs[a].second] < rankOf[pairs[b].second]; });
    put(stages.search.listStarts, starts, PARITY * starts.size());
    put(stages.search.pairReferences, references);
    gpu::Counters now = counters();
    now.pairCount = static_cast<uint32_t>(pairs.size());
    now.colliderPairCount = static_cast<uint32_t>(colliderContacts.size());
    setCounters(now);
}

}  // namespace knuckle::test
