#include <set>

#include "tests/rig/actor_fixture.h"
#include "tests/rig/figures/box_figure.h"

namespace knuckle::test {
namespace {

/// A figure whose legs and arms touch each other and the trunk. @param across 0 along x, 2 along z.
BoxBones blocks(int across)
{
    BoxBones bones{{"Body", "", {0, 0.63f, 0}, {0, 0.98f, 0}, {0.2f, 0.35f, 0.1f}},
                   {"Head", "Body", {0, 1.33f, 0}, {0, 1.55f, 0}, {0.21f, 0.21f, 0.21f}}};
    for (const float x : {1.0f, -1.0f}) {
        const std::string side = x > 0 ? "_Left" : "_Right";
        bones.push_back({"Arm" + side, "Body", {0.3f * x, 1.25f, 0}, {0.3f * x, 0.98f, 0}, {0.1f, 0.35f, 0.1f}});
        bones.push_back({"Leg" + side, "Body", {0.1f * x, 0.63f, 0}, {0.1f * x, 0.315f, 0}, {0.1f, 0.315f, 0.1f}});
    }
    for (BoxBone& bone : bones)
        for (Vector3f* v : {&bone.head, &bone.centre, &bone.half})
            if (across == 2) std::swap(v->x(), v->z());
    return bones;
}

float lowest(const Actor& actor, const std::string& body)
{
    float y = 1e9f;
    for (const uint32_t p : bodyOf(actor, body).particles) y = std::min(y, actor.particles[p].y());
    return y;
}

/// How many pieces a body has, of particles less than two diameters apart.
size_t piecesOf(const Actor& actor, const ActorBody& body)
{
    std::set<uint32_t> left(body.particles.begin(), body.particles.end());
    size_t pieces = 0;
    while (!left.empty()) {
        ++pieces;
        std::vector<uint32_t> queue{*left.begin()};
        left.erase(left.begin());
        for (size_t i = 0; i < queue.size(); ++i) {
            for (auto p = left.begin(); p != left.end();) {
                const bool near = (actor.particles[*p] - actor.particles[queue[i]]).norm() < 2 * actor.diameter;
                if (near) queue.push_back(*p);
                p = near ? left.erase(p) : std::next(p);
            }
        }
    }
    return pieces;
}

TEST(Seams, ATrunkEndsWhereTheLegsBegin)
{
    for (const int across : {0, 2}) {
        for (const float diameter : {0.05f, 0.0667f, 0.08f}) {
            const Actor actor = make(boxFigure(blocks(across)), diameter);
            expectSound(actor);
            EXPECT_GE(lowest(actor, "Body"), 0.63f - diameter) << diameter;
            EXPECT_EQ(bodyOf(actor, "Leg_Left").particles.size(), bodyOf(actor, "Leg_Right").particles.size());
            for (const ActorBody& body : actor.bodies) EXPECT_EQ(piecesOf(actor, body), 1u) << body.name;
        }
    }
}

TEST(Seams, LegsKeepToTheirSide)
{
    const Actor actor = make(boxFigure(blocks(0)), 0.06f);
    for (const uint32_t p : bodyOf(actor, "Leg_Left").particles) EXPECT_GT(actor.particles[p].x(), 0.0f);
    for (const uint32_t p : bodyOf(actor, "Leg_Right").particles) EXPECT_LT(actor.particles[p].x(), 0.0f);
}

TEST(Seams, APieceThatHangsApartGoesToWhatItTouches)
{
    // A weight at the end of a long arm wrongly follows the trunk, a third of the trunk's size.
    BoxBones bones = blocks(0);
    for (BoxBone& bone : bones)
        if (bone.name.starts_with("Arm")) bone.centre.y() = 0.83f, bone.half.y() = 0.5f;
    Model model = boxFigure(bones);
    const TriangleMesh cuff = boxMesh({0.39f, 0.08f, 0}, {0.11f, 0.25f, 0.13f});
    const auto first = static_cast<uint32_t>(model.vertices.size());
    for (const Vector3f& vertex : cuff.vertices) {
        model.vertices.push_back(vertex);
        model.skin.push_back({{indexOf(model, "Body")}, {1.0f}});
    }
    for (const Triangle& t : cuff.triangles) model.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    const Actor actor = make(model, 0.0667f);
    EXPECT_EQ(piecesOf(actor, bodyOf(actor, "Body")), 1u);
    EXPECT_LT(lowest(actor, "Arm_Left"), -0.1f);
}

}  // namespace
}  // namespace knuckle::test
