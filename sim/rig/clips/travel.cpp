#include "sim/rig/clips/travel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/base/angles.h"
#include "sim/base/errors.h"
#include "sim/rig/clips/ground_contact.h"

namespace knuckle {

namespace {

constexpr float AHEAD = 0.5f;         // of the path: how far ahead a figure looks, in heights of the pivot
constexpr float TURNING = 0.2f;       // [s] in which it corrects most of its deviation from that direction
constexpr float LEAST_SPEED = 0.02f;  // [m/s] of feet that carry a figure

/// Turns about y, as seen from above with z downwards; a yaw of BodyClip's turns.
Ground turned(float yaw, const Ground& p)
{
    const float c = std::cos(yaw), s = std::sin(yaw);
    return {c * p.x() + s * p.y(), c * p.y() - s * p.x()};
}

float yawTowards(const Ground& direction)
{
    return std::atan2(direction.x(), direction.y());
}

float nearestTurn(float angle)
{
    return std::remainder(angle, WHOLE_TURN);
}

/// Place and direction of a clip's frame on the ground.
struct Frame {
    Ground place{0, 0};
    float yaw = 0.0f;

    Ground operator()(const Ground& p) const { return place + turned(yaw, p); }
    /// Turns and moves so that a point of the clip stays in place while it moves from `before` to `after` in the clip.
    void hold(const Ground& before, const Ground& after, float turn)
    {
        const Ground fixed = (*this)(before);
        yaw += turn;
        place = fixed - turned(yaw, after);
    }
};

/// A line of points on the ground that continues straight beyond its end.
class Path {
public:
    explicit Path(const Ground& start) : points_{start} {}
    void add(const Ground& point)
    {
        if ((point - points_.back()).norm() > 1e-4f) points_.push_back(point);
    }
    bool leadsAnywhere() const { return points_.size() > 1; }
    Ground direction(size_t leg) const { return (points_[leg + 1] - points_[leg]).normalized(); }
    /// The point that a figure looks at, so far ahead. It does not return to legs that it has passed.
    Ground target(const Ground& from, float ahead)
    {
        const size_t last = points_.size() - 2;
        while (leg_ < last && along(leg_, from) + 0.5f * ahead >= length(leg_)) ++leg_;
        size_t leg = leg_;
        float way = std::max(along(leg, from), 0.0f) + ahead;
        while (leg < last && way > length(leg)) way -= length(leg++);
        return points_[leg] + way * direction(leg);
    }

private:
    float length(size_t leg) const { return (points_[leg + 1] - points_[leg]).norm(); }
    float along(size_t leg, const Ground& p) const { return (p - points_[leg]).dot(direction(leg)); }

    std::vector<Ground> points_;
    size_t leg_ = 0;
};

void addKey(const BodyClip& from, uint32_t key, const Frame& frame, BodyClip& to)
{
    const Ground root = frame(groundOf(from.roots[key]));
    to.roots.emplace_back(root.x(), from.roots[key].y(), root.y());
    const Quaternionf about(Eigen::AngleAxisf(frame.yaw, Vector3f::UnitY()));
    for (uint32_t b = 0; b < from.bodyCount; ++b) {
        const Quaternionf& turn = from.turns[key * from.bodyCount + b];
        Quaternionf now = b == 0 ? (about * turn).normalized() : turn;
        const size_t index = to.turns.size();
        if (b == 0 && index > 0 && now.dot(to.turns[index - to.bodyCount]) < 0.0f) now.coeffs() *= -1.0f;
        to.turns.push_back(now);
    }
}

BodyClip emptyCopy(const BodyClip& clip)
{
    BodyClip copy;
    copy.name = clip.name;
    copy.rate = clip.rate;
    copy.bodyCount = clip.bodyCount;
    return copy;
}

/// Moves from one key to the next; while no foot is down, as between the last two keys with one down.
class Gait {
public:
    Gait(const Actor& actor, const BodyClip& clip) : contacts_(groundContacts(actor, clip))
    {
        Ground last(0, 0);
        for (int round = 0; round < 2; ++round)  // keys before the first contact move like the round's end
            for (size_t k = 0; k < contacts_.size(); ++k) {
                GroundContact& contact = contacts_[k];
                const Ground root = groundOf(clip.roots[k]), next = groundOf(clip.roots[k + 1]);
                isAnyThere_ = isAnyThere_ || contact.isThere;
                if (contact.isThere) {
                    last = (next - contact.after) - (root - contact.before);
                    continue;
                }
                contact.before = root;
                contact.after = next - last;  // when held, it moves on by `last`
            }
    }
    bool isOnFeet() const { return isAnyThere_; }
    void go(Frame& frame, uint32_t key, float turn) const
    {
        frame.hold(contacts_[key].before, contacts_[key].after, turn);
    }

private:
    std::vector<GroundContact> contacts_;
    bool isAnyThere_ = false;
};

TravelClip straightOn(const Gait& gait, const BodyClip& clip)
{
    TravelClip travel{emptyCopy(clip), 0.0f};
    Frame frame;
    for (uint32_t k = 0; k < clip.keyCount(); ++k) {
        addKey(clip, k, frame, travel.clip);
        if (k + 1 < clip.keyCount()) gait.go(frame, k, 0.0f);
    }
    const Ground way = groundOf(travel.clip.roots.back()) - groundOf(travel.clip.roots.front());
    travel.speed = clip.duration() > 0.0f ? way.norm() / clip.duration() : 0.0f;
    if (!gait.isOnFeet() || travel.speed < LEAST_SPEED)
        throw InputError(
            fmt::format("the feet of clip \"{}\" carry it nowhere; take another, or another `root`", clip.name));
    return travel;
}

}  // namespace

TravelClip travelOnFeet(const Actor& actor, const BodyClip& clip)
{
    return straightOn(Gait(actor, clip), clip);
}

TravelClip travelAlong(const Actor& actor, const BodyClip& clip, const std::vector<Eigen::Vector2f>& path, float start,
                       float duration)
{
    const Gait gait(actor, clip);
    const TravelClip straight = straightOn(gait, clip);
    const Ground origin = groundOf(clip.roots.front());
    Path line(origin);
    for (const Ground& point : path) line.add(origin + point);
    if (!line.leadsAnywhere()) throw InputError("leads nowhere; give it a point elsewhere than where the actor stands");
    const float facing = yawTowards(groundOf(straight.clip.roots.back()) - origin);
    const auto keys = static_cast<uint32_t>(std::ceil(duration * clip.rate)) + 1, round = clip.keyCount() - 1;
    uint32_t key = static_cast<uint32_t>(std::lround(start * clip.rate)) % round;
    Frame frame;
    frame.yaw = nearestTurn(yawTowards(line.direction(0)) - facing);
    frame.place = origin - turned(frame.yaw, groundOf(clip.roots[key]));
    const float ahead = AHEAD * clip.roots.front().y(), share = 1.0f - std::exp(-1.0f / (TURNING * clip.rate));
    TravelClip travel{emptyCopy(clip), straight.speed};
    for (uint32_t k = 0; k < keys; ++k) {
        addKey(clip, key, frame, travel.clip);
        const Ground root = frame(groundOf(clip.roots[key]));
        const float off = nearestTurn(yawTowards(line.target(root, ahead) - root) - facing - frame.yaw);
        gait.go(frame, key, share * off);
        if (++key < round) continue;
        // The last key is the first one of the next round.
        const Ground end = frame(groundOf(clip.roots[round]));
        key = 0;
        frame.place = end - turned(frame.yaw, groundOf(clip.roots[0]));
    }
    return travel;
}

}  // namespace knuckle
