#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>

#include "app/states/view_coding.h"
#include "sim/base/errors.h"
#include "tests/message_of.h"
#include "tests/temp_folder.h"
#include "tests/world/world_fixture.h"

namespace knuckle::test {
namespace {

bool sameBits(const std::vector<gpu::vec4>& a, const std::vector<gpu::vec4>& b, size_t components)
{
    if (a.size() != b.size()) return false;
    for (size_t i = 0; i < a.size(); ++i)
        if (std::memcmp(&a[i], &b[i], 4 * components) != 0) return false;
    return true;
}

/// A state with the bodies somewhere, every particle where its body has it.
ViewState posed(const World& world, std::mt19937& random)
{
    std::normal_distribution<float> normal;
    const auto vector = [&](float w) { return gpu::vec4{normal(random), normal(random), normal(random), w}; };
    ViewState view;
    view.positions.assign(world.particles.size(), {});
    for (size_t p = 0; p < world.particles.size(); ++p) view.velocities.push_back(vector(0));
    for (size_t b = 0; b < world.bodies.size(); ++b) {
        const Quaternionf q = Quaternionf(normal(random), normal(random), normal(random), normal(random)).normalized();
        view.bodyCentres.push_back(vector(0));
        view.bodyRotations.push_back({q.x(), q.y(), q.z(), q.w()});
        const gpu::vec4& c = view.bodyCentres.back();
        for (const Link& link : world.links) {
            if (link.body != b || world.particles[link.particle].body != b) continue;
            const Vector3f place = Vector3f(c.x, c.y, c.z) + q * link.restOffset;
            view.positions[link.particle] = {place.x(), place.y(), place.z(), 0};
        }
    }
    for (size_t c = 0; c < 2 * world.colliders.size(); ++c) view.colliderPlaces.push_back(vector(normal(random)));
    return view;
}

class ViewCodingTest : public testing::Test {
protected:
    ViewCodingTest() : world(jointedCubes({})) { world.colliders.emplace_back(); }

    /// Writes and reads a frame.
    ViewState through(const ViewState& view)
    {
        const ViewCoding coder(world);
        const std::string path = folder.path("view.states");
        BlockWriter writer(path);
        for (const std::string& block : coder.pack(7, view)) writer.add(block);
        writer.commit();
        const BlockReader reader(path);
        stored = 0;
        for (const auto& block : reader.list())
            if (block.name == "frame 7/positions") stored = block.stored;
        return coder.unpack(reader, 7);
    }
    void expectSame(const ViewState& view)
    {
        const ViewState back = through(view);
        EXPECT_TRUE(sameBits(back.positions, view.positions, 4));
        EXPECT_TRUE(sameBits(back.velocities, view.velocities, 3));
        EXPECT_TRUE(sameBits(back.bodyCentres, view.bodyCentres, 3));
        EXPECT_TRUE(sameBits(back.bodyRotations, view.bodyRotations, 4));
        EXPECT_TRUE(sameBits(back.colliderPlaces, view.colliderPlaces, 4));
        EXPECT_TRUE(sameBits(back.foamPlaces, view.foamPlaces, 4));
        EXPECT_EQ(back.torn, view.torn);
        EXPECT_EQ(back.ages, view.ages);
        EXPECT_EQ(back.contactForces, view.contactForces);
        // Whole words are stored; nothing, if none is torn.
        for (size_t i = 0; i < view.tornDistances.size(); ++i)
            EXPECT_EQ(i < back.tornDistances.size() && back.tornDistances[i], view.tornDistances[i]) << i;
    }

    World world;
    TempFolder folder;
    uint64_t stored = 0;  ///< Bytes of the positions in the file.
};

TEST_F(ViewCodingTest, KeepsEveryBit)
{
    std::mt19937 random(3);
    for (int round = 0; round < 20; ++round) {
        ViewState view = posed(world, random);
        if (round % 3 == 1) view.ages.assign(world.particles.size(), 0.1f * static_cast<float>(round));
        if (round % 3 == 2) view.contactForces.assign(world.particles.size(), 1.0f / static_cast<float>(round));
        if (round % 2 == 1)
            for (size_t p = 0; p < world.particles.size(); ++p) view.torn.push_back(random() % 3 == 0);
        for (int k = 0; k < 7 * round; ++k) view.tornDistances.push_back(random() % 5 == 0);
        for (gpu::vec4& position : view.positions) position.w = random() % 2 == 0 ? 1.0f : 0.0f;
        for (int k = 0; k < round; ++k) view.foamPlaces.push_back({1.0f / float(k), -float(k), 0.1f, 0.3f * float(k)});
        expectSame(view);
    }
}

TEST_F(ViewCodingTest, KeepsFloatsThatAreNoUsualNumbers)
{
    std::mt19937 random(4);
    ViewState view = posed(world, random);
    const float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    view.positions[0] = {-0.0f, 0.0f, std::numeric_limits<float>::denorm_min(), 0};
    view.positions[1] = {infinity, -infinity, nan, 0};
    view.positions[2] = {std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest(), -nan, 0};
    view.velocities[0] = {nan, -0.0f, infinity, 0};
    view.bodyCentres[1] = {nan, infinity, -0.0f, 0};
    expectSame(view);
}

TEST_F(ViewCodingTest, StoresBodiesAsPoses)
{
    std::mt19937 random(5);
    through(posed(world, random));
    // Where a particle stands is off by a few floats at most: of four bytes a coordinate three are the same for all.
    EXPECT_LT(stored, 3 * world.particles.size() * 4 / 3);
}

TEST_F(ViewCodingTest, RefusesAFrameOfAnotherWorld)
{
    std::mt19937 random(6);
    through(posed(world, random));
    const BlockReader reader(folder.path("view.states"));
    World other = world;
    other.particles.push_back(other.particles.back());
    EXPECT_TRUE(
        messageOf<InputError>([&] { ViewCoding(other).unpack(reader, 7); }).ends_with("it is of another scene"));
    EXPECT_EQ(messageOf<InputError>([&] { ViewCoding(world).unpack(reader, 8); }),
              reader.path() + ": has no block \"frame 8/centres\"");
}

}  // namespace
}  // namespace knuckle::test
