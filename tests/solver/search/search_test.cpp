#include "tests/solver/search/search_test.h"

#include <algorithm>

namespace knuckle::test {

namespace {

constexpr uint32_t CAPACITY = 100000;

/// Makes the bodies of every other joint never touch.
World withNeighbours(World world)
{
    for (size_t j = 0; j < world.joints.size(); j += 2) {
        const Joint& joint = world.joints[j];
        world.bodies[joint.child].filtered.push_back(joint.parent);
        world.bodies[joint.parent].filtered.push_back(joint.child);
    }
    return world;
}

}  // namespace

SearchBench::SearchBench() : KernelFixture(withNeighbours(mixedWorld()))
{
    stages.parameters.candidateCapacity = 2 * CAPACITY;
    stages.parameters.pairCapacity = stages.parameters.colliderPairCapacity = CAPACITY;
    stages.search.makeLists();
    stages.contacts.makeLists();
    stages.uploadParameters();
    places = stages.particles.particleRanks.download();
    reaches.assign(stages.parameters.moverCount, 0.0f);
    bodies.resize(count());
    for (const Link& link : world.links) bodies[link.particle].insert(link.body);
    auto positions = randomVectors(count(), 0.5f, 11);
    for (uint32_t i = 0; i < count(); ++i)
        if (!bodies[i].empty()) positions[i] = packed(0.4f * vec3(positions[i]));
    place(positions);
}

void SearchBench::place(const std::vector<gpu::vec4>& positions)
{
    found = positions;
    setFound(found);
}

float restDistance(const Particle& a, const Particle& b)
{
    return (a.restPosition - b.restPosition).norm();
}

float leastRestDistance(const Particle& a, const Particle& b)
{
    return (0.99f + std::max(a.selfMargin, b.selfMargin)) * DIAMETER;
}

bool SearchBench::mayTouch(uint32_t i, uint32_t j) const
{
    const auto isFixed = [&](uint32_t k) {
        const uint32_t body = world.particles[k].body;
        return body != NO_INDEX && world.bodies[body].motion == Motion::Fixed;
    };
    if (isFixed(i) && isFixed(j)) return false;
    const Particle& a = world.particles[i];
    const Particle& b = world.particles[j];
    for (uint32_t body : bodies[i]) {
        if (bodies[j].contains(body)) return false;
        for (uint32_t other : world.bodies[body].filtered)
            if (bodies[j].contains(other)) return false;
    }
    if (a.assembly == NO_INDEX || a.assembly != b.assembly) return true;
    return a.touchesAssembly && b.touchesAssembly && restDistance(a, b) > leastRestDistance(a, b);
}

Eigen::Vector2f halves(uint32_t packedFrictions)
{
    const auto half = [](uint32_t bits) {
        return static_cast<float>(Eigen::numext::bit_cast<Eigen::half>(static_cast<uint16_t>(bits)));
    };
    return {half(packedFrictions & 0xffffu), half(packedFrictions >> 16)};
}

float SearchBench::limitOf(uint32_t i, uint32_t j) const
{
    return stages.parameters.contactReach + reaches[moverOf(i)] + reaches[moverOf(j)];
}

void SearchBench::makeSomeFast()
{
    Random random(13);
    std::vector<float> lengths(reaches.size(), 0.0f);
    for (size_t m = 0; m < lengths.size(); m += m < world.bodies.size() ? 4 : 9)
        lengths[m] = (m == 0 ? 1.0f : random.between(0.05f, 1.0f)) * stages.parameters.farReach;
    setReaches(lengths);
}

void SearchBench::setReaches(const std::vector<float>& lengths)
{
    reaches = lengths;
    std::vector<gpu::vec4> centres;
    for (float reach : reaches) centres.push_back(packed({0, 0, 0}, stages.parameters.drift + reach));
    fill(stages.search.searchCentres, centres);
    std::vector<uint32_t> fast;
    for (uint32_t i = 0; i < count(); ++i)
        if (isFast(i)) fast.push_back(2 * i);
    gpu::Counters now = counters();
    now.fastListed = static_cast<uint32_t>(fast.size());
    setCounters(now);
    fast.resize(count());
    fill(stages.search.fastParticles, fast);
}

std::vector<std::vector<uint32_t>> SearchBench::notedPairs() const
{
    const auto counts = stages.search.listCounts.download();
    std::vector<std::vector<uint32_t>> lists(count());
    for (uint32_t i = 0; i < count(); ++i) lists[i].resize(counts[rankOf(i)], NO_INDEX);
    for (const gpu::uvec4& candidate : candidates())
        if (candidate.w != NO_INDEX) lists[candidate.x].at(candidate.z) = candidate.y;
    return lists;
}

std::vector<gpu::uvec4> SearchBench::candidates() const
{
    auto all = stages.search.candidates.download();
    all.resize(std::min(counters().candidateCount, stages.parameters.candidateCapacity));
    return all;
}

void SearchBench::narrow(uint32_t candidates, uint32_t pairs, uint32_t colliderPairs)
{
    stages.parameters.candidateCapacity = candidates;
    stages.parameters.pairCapacity = pairs;
    stages.parameters.colliderPairCapacity = colliderPairs;
    setParameters();
}

}  // namespace knuckle::test
