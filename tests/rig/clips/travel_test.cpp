#include "sim/rig/clips/travel.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/base/errors.h"
#include "sim/rig/bodies/make_actor.h"
#include "sim/rig/clips/body_clip.h"
#include "tests/message_of.h"
#include "tools/dog/dog.h"
#include "tools/humanoid/humanoid.h"
#include "tools/spider/spider.h"

namespace knuckle::test {

namespace {

using Eigen::Vector2f;

/// A figure with a clip that moves over the ground, and the same clip on the spot.
struct Walker {
    Walker(const Model& model, const std::string& clipName, float diameter)
    {
        ActorOptions options;
        options.voxels.diameter = diameter;
        actor = makeActor(model, options);
        going = ownClip(actor, model, *std::ranges::find(model.clips, clipName, &Clip::name)).clip;
        onTheSpot = going;
        const Vector3f way = going.roots.back() - going.roots.front();
        speed = Vector2f(way.x(), way.z()).norm() / going.duration();
        for (uint32_t k = 0; k < going.keyCount(); ++k) {
            const float part = static_cast<float>(k) / static_cast<float>(going.keyCount() - 1);
            onTheSpot.roots[k] -= Vector3f(part * way.x(), 0, part * way.z());
        }
    }

    Actor actor;
    BodyClip going, onTheSpot;
    float speed = 0.0f;
};

/// Motion of an actor's particles in a clip.
class Played {
public:
    Played(const Actor& actor, const BodyClip& clip, bool loop) : builder_(0.5f * actor.diameter)
    {
        const uint32_t object = addActor(builder_, actor, builder_.addMaterial({}), {});
        ClipPlay play;
        play.clip = builder_.addClip(clip);
        play.loop = loop;
        builder_.animate({object, {}, pivotOf(actor), {play}});
        world_ = builder_.build();
    }
    std::vector<Vector3f> at(double time) const
    {
        const std::vector<Pose> poses = bodyPlaces(world_, world_.animations[0], time);
        std::vector<Vector3f> places(world_.particles.size());
        for (const Link& link : world_.links) places[link.particle] = poses[link.body].apply(link.restOffset);
        return places;
    }
    /// The farthest that a particle moves over the ground while within a centimetre of it [m]. Soles of spheres roll by
    /// some millimetres.
    float sliding(double seconds) const
    {
        constexpr int RATE = 120;
        const auto steps = static_cast<int>(seconds * RATE);
        std::vector<std::vector<Vector3f>> all;
        float ground = 1e9f;
        for (int k = 0; k <= steps; ++k) {
            all.push_back(at(double(k) / RATE));
            for (const Vector3f& p : all.back()) ground = std::min(ground, p.y());
        }
        float farthest = 0.0f;
        for (size_t p = 0; p < all[0].size(); ++p) {
            const Vector3f* start = nullptr;
            for (const auto& places : all) {
                if (places[p].y() > ground + 0.01f) start = nullptr;
                else if (start == nullptr) start = &places[p];
                else farthest = std::max(farthest, std::hypot(places[p].x() - start->x(), places[p].z() - start->z()));
            }
        }
        return farthest;
    }

private:
    WorldBuilder builder_;
    World world_;
};

void expectOnItsFeet(const Model& model, const std::string& clip, float diameter)
{
    SCOPED_TRACE(model.name + " " + clip);
    const Walker walker(model, clip, diameter);
    const TravelClip travel = travelOnFeet(walker.actor, walker.onTheSpot);
    // Its clip was made for this speed; feet that come down and lift give it within a few per cent.
    EXPECT_NEAR(travel.speed, walker.speed, 0.05f * walker.speed);
    const float slid = Played(walker.actor, walker.onTheSpot, true).sliding(walker.going.duration());
    const float slides = Played(walker.actor, travel.clip, true).sliding(2.0 * walker.going.duration());
    EXPECT_GT(slid, 0.1f);
    EXPECT_LT(slides, 0.02f);
    for (uint32_t k = 0; k < travel.clip.keyCount(); ++k)
        EXPECT_EQ(travel.clip.roots[k].y(), walker.onTheSpot.roots[k].y());
    EXPECT_EQ(travel.clip.turns.size(), walker.onTheSpot.turns.size());
    // A moving clip continues unchanged, except for its sliding.
    EXPECT_NEAR(travelOnFeet(walker.actor, walker.going).speed, walker.speed, 0.05f * walker.speed);
}

TEST(Travel, TheFootOnTheGroundStandsStill)
{
    expectOnItsFeet(makeHumanoid(), "walk", 0.04f);
    expectOnItsFeet(makeDog(), "walk", 0.03f);
    expectOnItsFeet(makeSpider(), "walk", 0.03f);
}

TEST(Travel, AlongAPathItTurnsAboutTheFootThatStands)
{
    const Walker walker(makeHumanoid(), "walk", 0.04f);
    // A quarter of a circle of 2 m, of points, and then straight on.
    std::vector<Vector2f> path;
    for (int k = 1; k <= 8; ++k) {
        const float angle = static_cast<float>(k) * std::numbers::pi_v<float> / 16.0f;
        path.emplace_back(2.0f - 2.0f * std::cos(angle), 2.0f * std::sin(angle));
    }
    const TravelClip travel = travelAlong(walker.actor, walker.onTheSpot, path, 0.0f, 6.0f);
    EXPECT_NEAR(travel.clip.duration(), 6.0f, 1.0f / travel.clip.rate);
    const Vector3f start = travel.clip.roots.front();
    float off = 0.0f, way = 0.0f;
    for (uint32_t k = 0; k < travel.clip.keyCount(); ++k) {
        const Vector3f p = travel.clip.roots[k] - start;
        if (k > 0) way += (travel.clip.roots[k] - travel.clip.roots[k - 1]).norm();
        const float distance = p.x() < 2.0f && p.z() < 2.0f ? std::abs(std::hypot(2.0f - p.x(), p.z()) - 2.0f)
                                                            : std::abs(p.z() - 2.0f);
        off = std::max(off, distance);
    }
    // It looks half a metre ahead, so it cuts corners by a few centimetres, and sways by as much.
    EXPECT_LT(off, 0.25f);
    EXPECT_NEAR(way, 6.0f * travel.speed, 0.08f * 6.0f * travel.speed);
    const Vector3f end = travel.clip.roots.back() - travel.clip.roots[travel.clip.keyCount() - 60];
    EXPECT_GT(end.x(), 0.9f * Vector2f(end.x(), end.z()).norm()) << "straight on behind its end";
    // Heel and toe of a foot of 0.25 m turn about its middle as the figure does, by 30 degrees in a step.
    EXPECT_LT(Played(walker.actor, travel.clip, false).sliding(6.0), 0.07f);
    // The middle of the standing foot does not move; for a figure that turns on straight legs the same as above.
    EXPECT_LT(Played(walker.actor, travelAlong(walker.actor, walker.onTheSpot, {{0, 9}}, 0.0f, 4.0f).clip, false)
                  .sliding(4.0),
              0.02f);
}

TEST(Travel, APathBeginsInItsOwnDirection)
{
    const Walker walker(makeHumanoid(), "walk", 0.05f);
    for (const Vector2f& to : {Vector2f(0, 3), Vector2f(3, 0), Vector2f(-3, 0), Vector2f(0, -3), Vector2f(-2, 2)}) {
        const TravelClip travel = travelAlong(walker.actor, walker.onTheSpot, {to}, 0.3f, 2.0f);
        const Vector3f way = travel.clip.roots.back() - travel.clip.roots.front();
        const Vector2f ground(way.x(), way.z());
        EXPECT_GT(ground.dot(to.normalized()), 0.98f * ground.norm()) << to.transpose();
        EXPECT_NEAR(ground.norm(), 2.0f * travel.speed, 0.2f) << to.transpose();
    }
}

TEST(Travel, FeetThatCarryNothingAreTold)
{
    const Walker walker(makeHumanoid(), "walk", 0.05f);
    BodyClip still = walker.onTheSpot;
    for (uint32_t k = 1; k < still.keyCount(); ++k)
        for (uint32_t b = 0; b < still.bodyCount; ++b) still.turns[k * still.bodyCount + b] = still.turns[b];
    for (Vector3f& root : still.roots) root = still.roots[0];
    EXPECT_NE(messageOf<InputError>([&] { travelOnFeet(walker.actor, still); }).find("carry it nowhere"),
              std::string::npos);
    EXPECT_NE(messageOf<InputError>([&] {
                  travelAlong(walker.actor, walker.onTheSpot, {{0, 0}}, 0, 1);
              }).find("leads nowhere"),
              std::string::npos);
}

}  // namespace

}  // namespace knuckle::test
