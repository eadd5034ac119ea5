#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "render/spheres/covered.h"
#include "render/unseen.h"
#include "sim/base/angles.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr uint32_t SIZE = 160;

const BodyShape BALL{0, {0, 0, 0}, {0, 0, 0}, 0.5f};
const BodyShape CAPSULE{0, {0, 0, 0}, {0, 0.45f, 0}, 0.25f};
const BodyShape CRATE{0, {0, 0, 0}, {0.4f, 0.4f, 0.4f}, 0.1f};
const BodyShape PLANK{0, {0.1f, 0, 0}, {0.8f, 0, 0.3f}, 0.06f};

Quaternionf turned(float angle, const Vector3f& axis)
{
    return Quaternionf(Eigen::AngleAxisf(angle, axis.normalized()));
}

uint32_t addShape(StillWorld& still, BodyShape shape, const Vector3f& position,
                  const Quaternionf& rotation = Quaternionf::Identity())
{
    shape.body = still.addBody({Vector3f::Zero()}, position, rotation);
    still.world.bodyShapes.push_back(shape);
    return shape.body;
}

/// Alternately red and blue, which the sky is not.
StillWorld redAndBlue(float radius = 0.01f)
{
    StillWorld still(radius);
    still.world.materials[0].color = {0.9f, 0.02f, 0.02f};
    still.world.materials[1].color = {0.02f, 0.02f, 0.9f};
    return still;
}

RenderSettings flatColors(float distance)
{
    RenderSettings settings = lookFrom({0, 0, distance}, {0, 0, 0}, SIZE, SIZE);
    settings.colorBy = ColorBy::Material;
    return settings;
}

/// -1 the backdrop, 0 red, 1 blue.
int shown(const Eigen::Vector3i& color)
{
    const int redness = color.x() - color.z();
    return redness > 35 ? 0 : redness < -60 ? 1 : -1;
}

/// Of the box inside a shape, from a point of the shape's frame.
float distanceFromBox(const BodyShape& shape, const Vector3f& place)
{
    return (place.cwiseAbs() - shape.halfSides).cwiseMax(0.0f).norm();
}

/// How far along the ray it meets the shape; infinity: not at all. Unlike the shader, by halving: the distance from a
/// box has one least along a line.
float firstHit(const World& world, const BodyShape& shape, const Vector3f& eye, const Vector3f& ray)
{
    const Body& body = world.bodies[shape.body];
    const Vector3f from = body.rotation.conjugate() * (eye - body.position) - (shape.middle - body.restCentre);
    const Vector3f way = body.rotation.conjugate() * ray;
    const auto at = [&](float t) { return distanceFromBox(shape, from + t * way) - shape.radius; };
    float low = 0.0f, high = 20.0f;
    for (int i = 0; i < 80; ++i) {
        const float a = low + (high - low) / 3.0f, b = high - (high - low) / 3.0f;
        (at(a) < at(b) ? high : low) = at(a) < at(b) ? b : a;
    }
    if (at(low) > 0.0f || at(0.0f) <= 0.0f) return INFINITY;
    float outside = 0.0f, inside = low;
    for (int i = 0; i < 40; ++i) {
        const float middle = 0.5f * (outside + inside);
        (at(middle) > 0.0f ? outside : inside) = middle;
    }
    return inside;
}

/// The shape that a pixel shows to a camera on the axis: its body modulo 2, or -1.
int expectedAt(const World& world, float distance, uint32_t x, uint32_t y)
{
    const float slope = std::tan(20.0f * DEGREE) * 2.0f / SIZE;
    const Vector3f ray((float(x) + 0.5f - 0.5f * SIZE) * slope, (0.5f * SIZE - float(y) - 0.5f) * slope, -1.0f);
    int hit = -1;
    float nearest = INFINITY;
    for (const BodyShape& shape : world.bodyShapes) {
        const float t = firstHit(world, shape, {0, 0, distance}, ray);
        if (t >= nearest) continue;
        nearest = t;
        hit = static_cast<int>(shape.body % 2);
    }
    return hit;
}

/// Every pixel whose neighbours and theirs expect the same shape must show it: the edge filter mixes the others.
void expectAsRayCast(const World& world, float distance)
{
    const Image image = drawn(world, flatColors(distance));
    std::vector<int> expected;
    for (uint32_t i = 0; i < SIZE * SIZE; ++i) expected.push_back(expectedAt(world, distance, i % SIZE, i / SIZE));
    int wrong = 0, judged = 0, shapes = 0;
    for (uint32_t y = 2; y + 2 < SIZE; ++y)
        for (uint32_t x = 2; x + 2 < SIZE; ++x) {
            const int here = expected[y * SIZE + x];
            bool inside = true;
            for (uint32_t n = 0; n < 25; ++n)
                inside = inside && expected[(y + n / 5 - 2) * SIZE + x + n % 5 - 2] == here;
            if (!inside) continue;
            ++judged;
            shapes += here >= 0;
            wrong += shown(pixelAt(image, x, y)) != here;
        }
    EXPECT_EQ(wrong, 0) << "of " << judged;
    EXPECT_GT(judged, static_cast<int>(SIZE * SIZE / 2));
    EXPECT_GT(shapes, static_cast<int>(SIZE * SIZE / 20));
}

TEST(Shapes, StandAndMeetWhereTheirSurfacesDo)
{
    StillWorld still = redAndBlue();
    addShape(still, CRATE, {-0.4f, 0.2f, 0}, turned(0.7f, {1, 2, 0.5f}));
    addShape(still, CAPSULE, {0.1f, 0.2f, 0.1f}, turned(1.1f, {0, 0.3f, 1}));
    addShape(still, PLANK, {0.3f, -0.6f, 0.2f}, turned(0.4f, {1, 0.5f, -1}));
    addShape(still, BALL, {0.7f, -0.3f, -0.3f});
    expectAsRayCast(still.world, 3.5f);
}

TEST(Shapes, StayWholeAtTheEdgeOfThePictureAndBeforeTheEye)
{
    StillWorld still = redAndBlue();
    addShape(still, CAPSULE, {0.7f, 0.6f, 0}, turned(0.9f, {1, 0, 0.4f}));
    addShape(still, CRATE, {-0.75f, 0.2f, 0.1f}, turned(0.5f, {1, 1, 0}));
    // The eye is inside the box around it, beside one of its edges.
    addShape(still, PLANK, {-0.08f, -0.35f, 1.9f}, turned(0.5f, {0, 0, 1}) * turned(1.2f, {1, 0, 0}));
    expectAsRayCast(still.world, 2.2f);
}

TEST(Shapes, TheSilhouetteOfABallHasTheClosedFormRadius)
{
    const float distance = 3.0f;
    StillWorld still = redAndBlue();
    addShape(still, BALL, {0, 0, 0}, turned(1.0f, {1, 1, 1}));
    const Image image = drawn(still.world, flatColors(distance));
    int covered = 0;
    for (uint32_t i = 0; i < SIZE * SIZE; ++i) covered += shown(pixelAt(image, i % SIZE, i / SIZE)) == 0;
    const double slope = BALL.radius / std::sqrt(distance * distance - BALL.radius * BALL.radius);
    const double expected = slope / std::tan(20.0 * std::numbers::pi / 180.0) * SIZE / 2.0;
    // Mixed edge pixels may count as red or not: half a pixel of the radius at most.
    EXPECT_NEAR(std::sqrt(covered / std::numbers::pi), expected, 0.5);
}

/// Pixels that differ by more than 8 of 255 in any channel.
int differing(const Image& one, const Image& other)
{
    int count = 0;
    for (size_t i = 0; i < one.rgb.size(); i += 3) {
        int most = 0;
        for (size_t k = i; k < i + 3; ++k) most = std::max(most, std::abs(one.rgb[k] - other.rgb[k]));
        count += most > 8;
    }
    return count;
}

TEST(Shapes, ABallAsLargeAsAParticleLooksLikeOneInEveryColour)
{
    for (const ColorBy colorBy : {ColorBy::Body, ColorBy::Material, ColorBy::Speed}) {
        StillWorld particle(0.3f), shape(0.3f);
        for (StillWorld* still : {&particle, &shape}) {
            still->addGround();
            still->addBody({Vector3f::Zero()}, {-0.4f, 0.3f, 0}, Quaternionf::Identity(), {2, 0, 0});
            still->addBody({Vector3f::Zero()}, {0.5f, 0.6f, 0}, turned(2.0f, {0, 1, 1}), {0, -3, 0});
        }
        for (const uint32_t body : {0u, 1u}) shape.world.bodyShapes.push_back({body, {0, 0, 0}, {0, 0, 0}, 0.3f});
        RenderSettings settings = lookFrom({1, 2, 5}, {0, 0.3f, 0}, SIZE, SIZE);
        settings.colorBy = colorBy;
        // In the shadow map a particle is a disc: a pixel of four may see another of the 15 levels of light.
        // Edges round differently.
        EXPECT_LT(differing(drawn(particle.world, settings), drawn(shape.world, settings)), 10) << int(colorBy);
    }
}

TEST(Shapes, OfSeveralParticlesHaveTheSpeedOfTheirMiddle)
{
    StillWorld spinning(0.1f), still(0.1f);
    for (StillWorld* world : {&spinning, &still}) {
        world->addBody(cubeLattice(4, 0.2f), {0, 0, 0}, Quaternionf::Identity(), {1, 0, 0});
        world->world.bodyShapes.push_back({0, {0, 0, 0}, {0.3f, 0.3f, 0.3f}, 0.1f});
    }
    for (Particle& particle : spinning.world.particles) particle.velocity += Vector3f(0, 9, 4).cross(particle.position);
    RenderSettings settings = flatColors(3.0f);
    settings.colorBy = ColorBy::Speed;
    EXPECT_EQ(drawn(spinning.world, settings).rgb, drawn(still.world, settings).rgb);
    for (Particle& particle : still.world.particles) particle.velocity *= 2.0f;
    EXPECT_GT(differing(drawn(spinning.world, settings), drawn(still.world, settings)), 1000);
}

/// A crate of 4 x 4 x 4 particles, or of those at its corners, which cast the same light.
World crate(bool whole, const std::vector<Vector3f>& more = {})
{
    StillWorld still(0.1f);
    still.addGround();
    std::vector<Vector3f> places;
    for (const Vector3f& place : cubeLattice(4, 0.2f))
        if (whole || place.cwiseAbs().minCoeff() > 0.29f) places.push_back(place);
    places.insert(places.end(), more.begin(), more.end());
    still.addBody(places, {0, 0.4f, 0});
    still.world.bodyShapes.push_back({0, {0, 0, 0}, {0.3f, 0.3f, 0.3f}, 0.1f});
    return still.world;
}

TEST(Shapes, HideTheParticlesInsideAndNoOthers)
{
    RenderSettings settings = lookFrom({1, 1, 2}, {0, 0.4f, 0}, SIZE, SIZE);
    settings.colorBy = ColorBy::Particle;  // of the shape: the body's
    const Image bare = drawn(crate(false), settings);
    EXPECT_EQ(drawn(crate(true), settings).rgb, bare.rgb);
    // A particle of a joint, in a layer beside the face: 0.1 m of radius at 2.2 m is 10 pixels.
    EXPECT_GT(differing(drawn(crate(true, {{0, 0, 0.5f}}), settings), bare), 200);
}

TEST(Shapes, HidePinsOfJointsButNotTheLayerBetweenBoxes)
{
    World world = crate(true, {{0, 0, 0.5f}});
    EXPECT_TRUE(hasBit(coveredParticles(world), 63));
    EXPECT_FALSE(hasBit(coveredParticles(world), 64));
    world.particles[64].touchesAssembly = false;
    EXPECT_TRUE(hasBit(coveredParticles(world), 64)) << "a pin";
    world.links.push_back({64, 1, {0, 0, 0}, 1.0f});
    Body cross;
    cross.isCross = true;
    cross.linkStart = 65;
    cross.linkCount = 1;
    world.bodies.push_back(cross);
    EXPECT_FALSE(hasBit(coveredParticles(world), 64)) << "of a universal joint";
}

TEST(Shapes, OfUnseenBodiesAreNotDrawn)
{
    StillWorld one(0.1f), two(0.1f);
    for (StillWorld* still : {&one, &two}) {
        still->addGround();
        addShape(*still, BALL, {0, 0.5f, 0});
    }
    const RenderSettings settings = lookFrom({0, 1, 6}, {0, 1, 0}, SIZE, SIZE);
    addShape(two, CRATE, {1.2f, 2.0f, 0});
    EXPECT_GT(differing(drawn(two.world, settings), drawn(one.world, settings)), 200);
    two.world.unseen = {{1, 2}};
    EXPECT_EQ(drawn(two.world, settings).rgb, drawn(one.world, settings).rgb);
}

TEST(Shapes, ShadeTheGroundAlongTheLightAndOnlyThere)
{
    StillWorld still(0.25f);
    still.addGround();
    still.addBody({{-0.5f, 0, 0}, {0, 0, 0}, {0.5f, 0, 0}}, {-1.5f, 2.0f, 0});
    still.world.bodyShapes.push_back({0, {0, 0, 0}, {0.5f, 0, 0}, 0.25f});
    RenderSettings settings = lookFrom({0, 8, 0}, {0, 0, 0}, SIZE, SIZE);
    settings.light.softness = 0.0f;
    settings.light.direction = {-1.0f, 1.0f, 0.0f};
    const Image image = drawn(still.world, settings);
    const auto brightness = [&](float x) {
        const float place = 0.5f * SIZE * (1.0f + x / (8.0f * std::tan(20.0f * DEGREE)));
        return pixelAt(image, static_cast<uint32_t>(place), SIZE / 2).sum() / 3;
    };
    // The light comes down at a slope of 1: the shadow's middle is 2 m to the +x of the capsule's, and its half
    // length 0.5 m and sqrt(2) times the radius. 0.15 m: as in Shadow.*.
    const int open = brightness(2.2f);
    for (const float inside : {-0.7f, -0.35f, 0.0f, 0.35f, 0.7f})
        EXPECT_LT(brightness(0.5f + inside), open - 20) << inside;
    for (const float outside : {-1.0f, 1.0f}) EXPECT_NEAR(brightness(0.5f + outside), open, 10) << outside;
}

}  // namespace
}  // namespace knuckle::test
