#include <cmath>
#include <numeric>

#include "render/frame_input.h"
#include "render/quantities/color_scale.h"
#include "render/quantities/quantity_pass.h"
#include "render/view/framing.h"
#include "sim/base/errors.h"
#include "sim/solver/solver.h"
#include "sim/world/builder/builder.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr float RADIUS = 0.05f, GRAVITY = 9.81f;

/// What colours show of each particle.
std::vector<float> shown(const World& world, const ParticleView& view, ColorBy quantity)
{
    RenderSettings settings;
    settings.colorBy = quantity;
    gpu::FrameInput input = frameInput(world, settings, sceneExtent(world));
    describeParticles(input, view, false);
    BufferTable table;
    Buffer<gpu::FrameInput> frame("frame", 1);
    frame.upload({&input, 1});
    RawBuffer positions = RawBuffer::standIn("positions", view.positions, view.particleCount * sizeof(gpu::vec4));
    table.add(Lifetime::Scratch, frame);
    table.add("positions", positions, elementType<gpu::vec4>(), Lifetime::Scratch);
    QuantityPass pass(sharedGpu(), table, world, settings);
    pass.attach(view);
    KernelTimer timer;
    pass.update(timer);
    std::vector<float> values(view.particleCount);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    table.find("shownQuantities", "test").buffer->read(values.data(), values.size() * sizeof(float));
    return values;
}

/// Water between walls, 6 x `layers` x 6 particles.
World column(int layers)
{
    WorldBuilder builder(RADIUS, Settings());
    Material water;
    water.fluid = true;
    const uint32_t fluid = builder.addMaterial(water);
    const float d = builder.fluidSpacing(), side = 6 * d;
    for (const auto& [place, normal] : {std::pair<Vector3f, Vector3f>{{0, 0, 0}, {0, 1, 0}},
                                        {{0, 0, 0}, {1, 0, 0}},
                                        {{side, 0, 0}, {-1, 0, 0}},
                                        {{0, 0, 0}, {0, 0, 1}},
                                        {{0, 0, side}, {0, 0, -1}}}) {
        Collider wall;
        wall.position = place;
        wall.orientation = Quaternionf::FromTwoVectors(Vector3f::UnitY(), normal);
        builder.addCollider(wall);
    }
    std::vector<Vector3f> places;
    for (int k = 0; k < 36 * layers; ++k)
        places.push_back(d * Vector3f(float(k % 6) + 0.5f, float(k / 36) + 0.5f, float(k / 6 % 6) + 0.5f));
    builder.addFluid(places, {0, 0, 0}, fluid);
    return builder.build();
}

TEST(Quantity, PressureGrowsWithDepthAsHydrostaticsSays)
{
    const World world = column(14);
    Solver solver(sharedGpu(), world);
    // The slope of pressure over height, over all particles but the layers at the surface and the floor, and over many
    // moments: single ones ring by waves of pressure.
    double sums[4] = {}, count = 0.0;
    for (int step = 0; step < 180; ++step) {
        solver.step();
        if (step < 120) continue;
        const std::vector<float> values = shown(world, solver.view(), ColorBy::Pressure);
        const std::vector<gpu::vec4> places = solver.readView().positions;
        for (size_t i = 0; i < values.size(); ++i) {
            const double y = places[i].y, p = values[i];
            if (y < 0.1 || y > 0.5) continue;
            sums[0] += y, sums[1] += p, sums[2] += y * y, sums[3] += y * p, ++count;
        }
    }
    const double slope = (count * sums[3] - sums[0] * sums[1]) / (count * sums[2] - sums[0] * sums[0]);
    // A particle's volume is known to the 1 % by which the lattice is denser than water, and what settles still moves.
    EXPECT_NEAR(slope, -1000.0 * GRAVITY, 0.05 * 1000.0 * GRAVITY);
    // Half way between 0.1 and 0.5 m, under 14 layers of 0.05 m, less what has settled.
    EXPECT_NEAR(sums[1] / count, 1000.0 * GRAVITY * (0.68 - sums[0] / count), 0.06 * 1000.0 * GRAVITY * 0.68);
}

TEST(Quantity, DensityIsThatAtRestInsideOfStillWater)
{
    const World world = column(10);
    Solver solver(sharedGpu(), world);
    for (int step = 0; step < 120; ++step) solver.step();
    const std::vector<float> values = shown(world, solver.view(), ColorBy::Density);
    const std::vector<gpu::vec4> places = solver.readView().positions;
    double sum = 0.0, count = 0.0;
    for (size_t i = 0; i < values.size(); ++i)
        if (places[i].y > 0.1f && places[i].y < 0.35f) sum += values[i], ++count;
    // Water that is pressed is at most 2 % denser.
    EXPECT_NEAR(sum / count, 1.0, 0.02);
}

TEST(Quantity, StrainIsThatOfTheStretchesOfAnEvenMap)
{
    WorldBuilder builder(RADIUS, Settings());
    const uint32_t material = builder.addMaterial(Material());
    builder.beginObject("cube");
    builder.addSoftBody("cube", cubeLattice(5, 2 * RADIUS), material);
    builder.endObject({});
    World world = builder.build();
    sharedGpu();
    // Turned after it is stretched: only the stretches count, sqrt(0.3^2 + 0.2^2 + 0.1^2) of them.
    const Eigen::AngleAxisf turn(0.7f, Vector3f(1, 2, 3).normalized());
    std::vector<float> before;
    {
        const StillBuffers buffers(world);
        before = shown(world, buffers.view(), ColorBy::Strain);
    }
    for (Particle& particle : world.particles)
        particle.position = turn * Vector3f(particle.position.array() * Eigen::Array3f(1.3f, 0.8f, 1.1f));
    const StillBuffers buffers(world);
    // Places have 24 bits of a metre; a stretch is their difference over 0.1 m.
    for (const float value : before) EXPECT_NEAR(value, 0.0f, 1e-4f);
    for (const float value : shown(world, buffers.view(), ColorBy::Strain)) EXPECT_NEAR(value, std::sqrt(0.14f), 1e-4f);
}

TEST(Quantity, AgeIsTheWayFromTheNozzleOverTheSpeed)
{
    constexpr float SPEED = 2.3f;
    constexpr int STEPS = 30;
    Settings settings;
    settings.gravity = {0, 0, 0};
    WorldBuilder builder(RADIUS, settings);
    Material water;
    water.fluid = true;
    Emitter emitter;
    emitter.material = builder.addMaterial(water);
    const float d = builder.fluidSpacing();
    emitter.nozzle = placed(rectangleNozzle(4 * d, 3 * d, d), {0, 1, 0}, {1, 0, 0});
    emitter.velocity = {SPEED, 0, 0};
    emitter.pool = 1000;
    builder.addEmitter(emitter);
    builder.beginObject("box");
    const uint32_t stone = builder.addMaterial(Material());
    builder.addBody("box", boxLattice({2, 2, 2}, 2 * RADIUS), stone);
    builder.endObject({Vector3f(0, 5, 0)});
    World world = builder.build();
    world.shown.ages = true;
    Solver solver(sharedGpu(), world);
    for (int step = 0; step < STEPS; ++step) solver.step();
    const std::vector<float> ages = shown(world, solver.view(), ColorBy::Age);
    const std::vector<gpu::vec4> places = solver.readView().positions;
    // What was there from the start; a sum of 30 steps.
    for (uint32_t i = 0; i < world.solidCount(); ++i)
        EXPECT_NEAR(ages[i], STEPS * world.settings.timeStep, 30 * 6e-8f) << i;
    uint32_t came = 0;
    for (size_t i = world.solidCount(); i < places.size(); ++i) {
        if (places[i].w != 0.0f) {
            EXPECT_EQ(ages[i], 0.0f) << i;
            continue;
        }
        ++came;
        // Emitter.LayersComeWhenTheyAreDueAndAsFarApartAsAtRestAtAnySpeed says how far a jet is off.
        EXPECT_NEAR(ages[i], places[i].x / SPEED, 0.004f * d / SPEED) << i;
    }
    EXPECT_EQ(came, 12u * (static_cast<uint32_t>(STEPS * world.settings.timeStep * SPEED / d) + 1u));
}

/// Boxes on top of each other on the ground, and what contacts press each with, mean over a second at rest [N].
std::vector<double> pressedBoxes(int count, World& world)
{
    WorldBuilder builder(RADIUS, Settings());
    const uint32_t stone = builder.addMaterial(Material());
    builder.addCollider({});
    for (int k = 0; k < count; ++k) {
        builder.beginObject("box");
        builder.addBody("box", boxLattice({4, 3, 4}, 2 * RADIUS), stone);
        builder.endObject({Vector3f(0, RADIUS * (3 + 6 * static_cast<float>(k)), 0)});
    }
    world = builder.build();
    world.shown.contactForces = true;
    Solver solver(sharedGpu(), world);
    std::vector<double> pressed(world.bodies.size());
    for (int step = 0; step < 180; ++step) {
        solver.step();
        if (step < 120) continue;
        const std::vector<float> values = shown(world, solver.view(), ColorBy::ContactForce);
        for (size_t i = 0; i < values.size(); ++i) pressed[world.particles[i].body] += values[i] / 60.0;
    }
    return pressed;
}

/// Each box is held up by what all from it on weigh, and pressed down by all above it. Seven form a stack.
TEST(Quantity, ContactForcesAtRestAreTheWeightsThatPassFromBothSides)
{
    for (const int count : {1, 2, 7}) {
        World world;
        const std::vector<double> pressed = pressedBoxes(count, world);
        const double weight = world.bodies[0].mass * GRAVITY;
        for (int k = 0; k < count; ++k) {
            const double carried = (2 * (count - k) - 1) * weight;
            // In a second it takes m g and what changes its speed, by less than a centimetre a second.
            EXPECT_NEAR(pressed[k], carried, 0.001 * carried) << k << " of " << count;
        }
    }
}

/// In a step of one substep, its mean is what the lists of contacts say on the host.
TEST(Quantity, ContactForcesAreThoseOfTheListsOfContacts)
{
    Settings settings;
    settings.substeps = 1;
    WorldBuilder builder(RADIUS, settings);
    const uint32_t stone = builder.addMaterial(Material());
    builder.addCollider({});
    for (int k = 0; k < 9; ++k) {
        builder.beginObject("box");
        builder.addBody("box", boxLattice({3, 2, 3}, 2 * RADIUS), stone);
        builder.endObject({Vector3f(0.07f * static_cast<float>(k % 4), 0.3f + 0.35f * static_cast<float>(k), 0.02f)});
    }
    World world = builder.build();
    world.shown.contactForces = true;
    Solver solver(sharedGpu(), world);
    for (int step = 0; step < 90; ++step) solver.step();
    std::vector<double> wanted(world.particles.size());
    for (const ContactForce& contact : solver.contactForces()) {
        wanted[contact.particle] += contact.force.norm();
        if (contact.other != NO_INDEX) wanted[contact.other] += contact.force.norm();
    }
    const std::vector<float> values = shown(world, solver.view(), ColorBy::ContactForce);
    // Sums of some ten floats.
    for (size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], wanted[i], 1e-5 * wanted[i] + 1e-6) << i;
    EXPECT_GT(std::reduce(wanted.begin(), wanted.end()), 9 * world.bodies[0].mass * GRAVITY);
}

TEST(Quantity, WhatIsNotKeptIsRefused)
{
    StillWorld still(RADIUS);
    still.addBody({{0, 0, 0}}, {0, 0, 0});
    sharedGpu();
    const StillBuffers buffers(still.world);
    for (const ColorBy quantity : {ColorBy::Age, ColorBy::ContactForce})
        EXPECT_THROW(shown(still.world, buffers.view(), quantity), RunError);
}

TEST(Quantity, WhatHasNoneIsGrey)
{
    StillWorld still(RADIUS);
    still.addBody({{0, 0, 0}}, {0, 0, 0});
    for (const ColorBy quantity : {ColorBy::Pressure, ColorBy::Density, ColorBy::Strain}) {
        RenderSettings settings = lookFrom({0, 0, 0.5f}, {0, 0, 0}, 64, 64);
        settings.colorBy = quantity;
        settings.light.color = settings.light.skyColor = settings.light.groundColor = {1, 1, 1};
        const Eigen::Vector3i pixel = pixelAt(drawn(still.world, settings), 32, 32);
        EXPECT_LE(pixel.maxCoeff() - pixel.minCoeff(), 3) << static_cast<int>(quantity);
    }
}

/// A speed of the share 0.37 of its scale looks as scaleColor() says: by the order of red, green and blue in each
/// palette, under white light.
TEST(Quantity, PalettesAndScalesAreThoseOfTheHost)
{
    StillWorld still(RADIUS);
    still.addBody({{0, 0, 0}}, {0, 0, 0}, Quaternionf::Identity(), {3, 0, 0});
    for (const Palette palette : {Palette::Viridis, Palette::Cividis, Palette::Turbo, Palette::Diverging}) {
        RenderSettings settings = lookFrom({0, 0, 0.5f}, {0, 0, 0}, 64, 64);
        settings.colorBy = ColorBy::Speed;
        settings.palette = palette;
        settings.toneMap = ToneMap::Linear;
        settings.light.color = settings.light.skyColor = settings.light.groundColor = {1, 1, 1};
        settings.light.intensity = 0.5f;
        // The colour of a plain body of the material's colour is the same.
        RenderSettings plain = settings;
        plain.colorBy = ColorBy::Material;
        for (const auto& [low, high] : {std::pair{0.0f, 8.0f}, {2.0f, 4.5f}, {3.5f, 6.0f}}) {
            settings.colorScale = Eigen::Vector2f(low, high);
            still.world.materials[0].color = scaleColor(palette, (3.0f - low) / (high - low));
            const Eigen::Vector3i wanted = pixelAt(drawn(still.world, plain), 32, 32);
            // Both round square roots to 8 bits.
            EXPECT_LE((pixelAt(drawn(still.world, settings), 32, 32) - wanted).cwiseAbs().maxCoeff(), 2)
                << static_cast<int>(palette) << ", " << low << ": " << wanted.transpose();
        }
    }
}

}  // namespace
}  // namespace knuckle::test
