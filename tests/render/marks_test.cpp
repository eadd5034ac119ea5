#include <cmath>
#include <numbers>

#include "render/marks/joint_marks.h"
#include "render/view/framing.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

const Vector3f ELBOW{0.4f, 0, 0};

/// Two cubes beside each other, connected by a joint at ELBOW: the second turns against the first.
World arm(JointType type, const Vector3f& axis = Vector3f::UnitZ())
{
    StillWorld still(0.05f);
    for (const float x : {0.0f, 0.8f}) {
        still.addBody(cubeLattice(3, 0.1f), {x, 0, 0});
        still.world.bodies.back().restCentre = {x, 0, 0};
    }
    Joint joint;
    joint.type = type;
    joint.parent = 0;
    joint.child = 1;
    joint.parentSide = {ELBOW, Quaternionf::FromTwoVectors(Vector3f::UnitX(), axis)};
    still.world.joints = {joint};
    return still.world;
}

/// Looks along -z: 400 pixels high, 200 pixels a metre at z = 0.
RenderSettings front()
{
    RenderSettings settings = lookFrom({0.4f, 0, 10}, {0.4f, 0, 0}, 400, 400);
    settings.camera.fieldOfView = 2.0f * std::atan(0.1f) / DEGREE;
    settings.markJoints = true;
    return settings;
}

Eigen::Vector3i colorAt(const Image& image, const Vector3f& place)
{
    return pixelAt(image, static_cast<uint32_t>(std::lround(200 + 200 * (place.x() - 0.4f))),
                   static_cast<uint32_t>(std::lround(200 - 200 * place.y())));
}

/// The largest of a channel [of 255].
float distance(const Eigen::Vector3i& color, const Vector3f& wanted)
{
    return (color.cast<float>() - 255.0f * wanted).cwiseAbs().maxCoeff();
}

/// Of two pictures, whether a pixel of them differs.
bool differs(const Image& a, const Image& b, const Vector3f& place)
{
    return (colorAt(a, place) - colorAt(b, place)).cwiseAbs().maxCoeff() > 6;
}

TEST(Marks, TellTheTypesOfJointsApart)
{
    for (const JointType type : {JointType::Ball, JointType::Hinge, JointType::Stiff})
        EXPECT_LE(distance(colorAt(drawn(arm(type), front()), ELBOW), markColor(type)), 2) << static_cast<int>(type);
    World universal = arm(JointType::Hinge);
    universal.bodies[0].isCross = true;
    EXPECT_LE(distance(colorAt(drawn(universal, front()), ELBOW), markColor(JointType::Universal)), 2);
    RenderSettings without = front();
    without.markJoints = false;
    EXPECT_GT(distance(colorAt(drawn(arm(JointType::Ball), without), ELBOW), markColor(JointType::Ball)), 60);
}

TEST(Marks, AreSeenThroughWhatIsInFrontOfThem)
{
    World world = arm(JointType::Ball);
    world.joints[0].parentSide.arm = {0, 0, 0};
    EXPECT_LE(distance(colorAt(drawn(world, front()), {0, 0, 0}), markColor(JointType::Ball)), 2);
}

TEST(Marks, AHingesFanGoesFromItsLowestToItsHighestAngle)
{
    World world = arm(JointType::Hinge);
    const Image plain = drawn(world, front());
    world.joints[0].limits.twist = {-10 * DEGREE, 100 * DEGREE};
    const Image fan = drawn(world, front());
    // The child lies along +x; it turns about +z, so up.
    const auto at = [](float angle) {
        return Vector3f(ELBOW + 0.05f * Vector3f(std::cos(angle * DEGREE), std::sin(angle * DEGREE), 0));
    };
    for (const float inside : {15.0f, 45.0f, 85.0f}) EXPECT_TRUE(differs(plain, fan, at(inside))) << inside;
    for (const float outside : {-40.0f, -90.0f, 125.0f, 180.0f}) EXPECT_FALSE(differs(plain, fan, at(outside)));
}

TEST(Marks, ABallsConeOpensAlongItsMiddle)
{
    World world = arm(JointType::Ball, Vector3f::UnitY());
    const Image plain = drawn(world, front());
    world.joints[0].limits.swing = 30 * DEGREE;
    const Image cone = drawn(world, front());
    EXPECT_TRUE(differs(plain, cone, ELBOW + Vector3f(0.01f, 0.055f, 0)));
    EXPECT_FALSE(differs(plain, cone, ELBOW + Vector3f(0.07f, 0.055f, 0)));
    EXPECT_FALSE(differs(plain, cone, ELBOW - Vector3f(0, 0.055f, 0)));
}

TEST(Marks, MoveWithTheParent)
{
    World world = arm(JointType::Ball);
    world.bodies[0].rotation = Quaternionf(Eigen::AngleAxisf(90 * DEGREE, Vector3f::UnitZ()));
    const Image image = drawn(world, front());
    EXPECT_LE(distance(colorAt(image, {0, 0.4f, 0}), markColor(JointType::Ball)), 2);
    EXPECT_GT(distance(colorAt(image, ELBOW), markColor(JointType::Ball)), 60);
}

TEST(Marks, ALegendNamesOnlyWhatIsThere)
{
    RenderSettings settings = front();
    settings.legend = true;
    // Its rows are 0.034 of the height, the first in the middle of 0.03 to 0.064.
    const Image image = drawn(arm(JointType::Stiff), settings);
    EXPECT_LE(distance(pixelAt(image, 16, 19), markColor(JointType::Stiff)), 2);
    const Image none = drawn(arm(JointType::Stiff), front());
    EXPECT_GT(distance(pixelAt(none, 16, 19), markColor(JointType::Stiff)), 10);
    EXPECT_EQ(pixelAt(image, 16, 33), pixelAt(none, 16, 33)) << "a second row";
}

TEST(Marks, ASkinIsAVeilOverWhatIsBehindIt)
{
    World world = arm(JointType::Ball);
    world.bodies[0].restCentre.setZero();
    SkinMesh mesh;
    for (const auto& [x, y] : {std::pair{-0.3f, -0.3f}, {0.3f, -0.3f}, {0.3f, 0.3f}, {-0.3f, 0.3f}}) {
        SkinVertex vertex;
        vertex.position = {x, y, 0.2f};
        vertex.normal = Vector3f::UnitZ();
        mesh.vertices.push_back(vertex);
    }
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.materials.resize(1);
    mesh.materials[0].color = {0.8f, 0.02f, 0.02f};
    world.objects = {{"arm", 0, 2}};
    RenderSettings settings = front();
    settings.markJoints = false;
    settings.skinOpacity = 0.5f;
    const Vector3f onParticles{0.1f, 0.02f, 0}, beside{-0.25f, 0, 0}, far{0.8f, 0.02f, 0};
    const Image bare = drawn(world, settings);
    world.skins = {{std::make_shared<SkinMesh>(mesh), {0}, SkinUse::Cover}};
    const Image veiled = drawn(world, settings);
    settings.skinOpacity = 1.0f;
    const Image solid = drawn(world, settings);
    for (const Vector3f& place : {onParticles, beside}) {
        const Eigen::Vector3i mean = (colorAt(bare, place) + colorAt(solid, place)) / 2;
        EXPECT_LE((colorAt(veiled, place) - mean).cwiseAbs().maxCoeff(), 12) << place.transpose();
        EXPECT_GT((colorAt(veiled, place) - colorAt(bare, place)).cwiseAbs().maxCoeff(), 25);
    }
    EXPECT_EQ(colorAt(veiled, far), colorAt(bare, far));
}

TEST(Framing, PutsAllPointsIntoTheirShareOfThePicture)
{
    const std::vector<Vector3f> points{{-1, 0, 0.5f}, {1, 0, -0.5f}, {0, 3, 0}, {0.2f, -0.5f, 2}};
    for (const Vector3f& back : {Vector3f(0, 0, 1), Vector3f(1, 0.2f, 0).normalized()}) {
        const Framing framing{.points = points, .back = back, .fieldOfView = 30, .aspect = 0.8f, .share = 0.9f};
        const CameraSettings camera = cameraThatFrames(framing);
        const Vector3f right = Vector3f::UnitY().cross(back).normalized(), up = back.cross(right);
        const float slope = std::tan(15 * DEGREE);
        Eigen::Array2f low = Eigen::Array2f::Constant(9), high = -low;
        for (const Vector3f& point : points) {
            const Vector3f from = point - camera.position;
            const Eigen::Array2f place(from.dot(right) / (0.8f * slope), from.dot(up) / slope);
            low = low.min(place / -from.dot(back));
            high = high.max(place / -from.dot(back));
        }
        const Eigen::Array2f most = high.max(-low);
        EXPECT_NEAR(most.maxCoeff(), 0.9f, 1e-4f);
        // The dimension that fills the picture is centred.
        EXPECT_NEAR(most.x() > most.y() ? low.x() + high.x() : low.y() + high.y(), 0.0f, 1e-4f);
        EXPECT_NEAR((camera.position - camera.target - back).norm(), 0.0f, 1e-5f);
    }
}

}  // namespace
}  // namespace knuckle::test
