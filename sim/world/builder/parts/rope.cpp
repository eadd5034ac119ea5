#include "sim/world/builder/parts/rope.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

using Eigen::Vector3d;

/// A chain that hangs at rest, described by the forces in its links, in units of a node's weight. All links pull
/// sideways by `pull`. The first pulls down by `first`, each further one by 1 less, as it carries one node less. A link
/// has the direction of its force.
struct Chain {
    uint32_t count;
    double pull, first;

    double across(uint32_t k) const { return pull / std::hypot(pull, first - k); }
    double down(uint32_t k) const { return (first - k) / std::hypot(pull, first - k); }
    double sum(double (Chain::*part)(uint32_t) const) const
    {
        double total = 0.0;
        for (uint32_t k = 0; k < count; ++k) total += (this->*part)(k);
        return total;
    }
};

constexpr int HALVINGS = 60;

/// The chain of `count` links whose ends are `drop` links apart along gravity, for a sideways pull.
Chain withDrop(uint32_t count, double pull, double drop)
{
    const double reach = count * (1.0 + pull) * 1e4;
    double low = -reach, high = reach;
    for (int i = 0; i < HALVINGS; ++i) {
        const double middle = 0.5 * (low + high);
        (Chain{count, pull, middle}.sum(&Chain::down) < drop ? low : high) = middle;
    }
    return {count, pull, 0.5 * (low + high)};
}

}  // namespace

std::vector<Vector3f> hangingChain(const Vector3f& from, const Vector3f& to, uint32_t count, float length,
                                   const Vector3f& gravity)
{
    const Vector3d start = from.cast<double>(), way = to.cast<double>() - start;
    std::vector<Vector3f> nodes;
    const double slack = 1.0 - way.norm() / (static_cast<double>(count) * length);
    if (slack < 1e-4 || count < 2) {
        for (uint32_t k = 0; k <= count; ++k) nodes.push_back((start + way * (double(k) / count)).cast<float>());
        return nodes;
    }
    const Vector3d down = gravity.norm() > 0.0f ? Vector3d(gravity.cast<double>().normalized()) : Vector3d(0, -1, 0);
    const double drop = way.dot(down) / length;
    Vector3d aside = way - down * way.dot(down);
    const double width = aside.norm() / length;
    aside = width > 1e-6 ? Vector3d(aside.normalized()) : down.unitOrthogonal();
    // Bisection over the logarithm of the pull: a small one lets the chain hang down, a large one pulls it taut.
    double low = std::log(1e-9), high = std::log(1e9);
    Chain chain{count, 1.0, 0.0};
    for (int i = 0; i < HALVINGS; ++i) {
        chain = withDrop(count, std::exp(0.5 * (low + high)), drop);
        (chain.sum(&Chain::across) < width ? low : high) = 0.5 * (low + high);
    }
    Vector3d node = start;
    nodes.push_back(from);
    for (uint32_t k = 0; k < count; ++k) {
        node += length * (chain.across(k) * aside + chain.down(k) * down);
        nodes.push_back(node.cast<float>());
    }
    return nodes;
}

namespace {

void checkRope(const RopeSpec& spec, float distance)
{
    const auto require = [](bool holds, const std::string& what) {
        if (!holds) throw InputError(what);
    };
    require(spec.length > 0.0f || distance > 0.0f, "the rope has no length; move its ends apart or set length");
    require(spec.length == 0.0f || spec.length >= 0.9999f * distance,
            fmt::format("length {} m of the rope is less than the {} m between its ends; make it longer or bring them "
                        "nearer",
                        spec.length, distance));
}

/// Adds a rope: its particles, a fixed body of one particle for each fixed end, and its distances.
class RopeBuilder {
public:
    RopeBuilder(WorldBuilder& builder, const RopeSpec& spec)
        : builder_(builder), spec_(spec), from_(placeOf(spec.start, spec.from)), to_(placeOf(spec.end, spec.to))
    {
        const float distance = (to_ - from_).norm();
        checkRope(spec, distance);
        length_ = spec.length > 0.0f ? spec.length : distance;
        count_ = static_cast<uint32_t>(std::max(1.0f, std::ceil(length_ / builder.diameter() - 1e-3f)));
        link_ = length_ / static_cast<float>(count_);
    }

    void add()
    {
        const std::vector<Vector3f> places = hangingChain(from_, to_, count_, link_, builder_.world().settings.gravity);
        if ((places.back() - to_).norm() > 0.01f * link_)
            throw InputError("the ends of the rope are too near each other for its length; move them a diameter apart");
        for (uint32_t k = 0; k <= count_; ++k) {
            const RopeEnd& end = k == 0 ? spec_.start : k == count_ ? spec_.end : RopeEnd{};
            nodes_.push_back(nodeAt(places[k], end, k == 0 || k == count_, k == 0 ? "start" : "end"));
        }
        addDistances();
    }

private:
    Vector3f placeOf(const RopeEnd& end, const Vector3f& place) const
    {
        return end.kind == RopeEnd::Kind::Attached ? builder_.world().particles.at(end.particle).position : place;
    }

    uint32_t nodeAt(const Vector3f& place, const RopeEnd& end, bool isEnd, const char* name)
    {
        if (end.kind == RopeEnd::Kind::Attached) return end.particle;
        if (end.kind == RopeEnd::Kind::Fixed) {
            builder_.addBody(name, std::span(&place, 1), spec_.material, Motion::Fixed);
            return builder_.particleCount() - 1;
        }
        const float diameter = builder_.diameter();
        Particle particle;
        particle.position = particle.restPosition = place;
        particle.selfMargin = ROPE_MARGIN;
        particle.material = spec_.material;
        particle.mass = builder_.world().materials.at(spec_.material).density * diameter * diameter * link_ *
                        (isEnd ? 0.5f : 1.0f);
        return builder_.addLooseParticle(particle);
    }

    void addDistances()
    {
        Strand row;
        row.particles = nodes_;
        row.restLengths.assign(count_, link_);
        row.compliance = spec_.compliance / static_cast<float>(count_);
        row.tearForce = spec_.tearForce;
        row.startRelease = spec_.start.releaseTime;
        row.endRelease = spec_.end.releaseTime;
        builder_.addStrand(row);
        if (spec_.drawn) builder_.drawRope();
        if (!std::isfinite(spec_.bendCompliance)) return;
        for (uint32_t first = 0; first < 2 && first + 2 <= count_; ++first) {
            Strand bend;
            bend.kind = DistanceKind::Bend;
            bend.compliance = spec_.bendCompliance;
            bend.tearForce = spec_.tearForce;
            for (uint32_t k = first; k <= count_; k += 2) bend.particles.push_back(nodes_[k]);
            bend.restLengths.assign(bend.particles.size() - 1, 2.0f * link_);
            if (first == 0) bend.startRelease = spec_.start.releaseTime;
            if ((count_ - first) % 2 == 0) bend.endRelease = spec_.end.releaseTime;
            builder_.addStrand(bend);
        }
    }

    WorldBuilder& builder_;
    const RopeSpec& spec_;
    Vector3f from_, to_;
    float length_ = 0.0f, link_ = 0.0f;
    uint32_t count_ = 1;
    std::vector<uint32_t> nodes_;
};

}  // namespace

uint32_t addRope(WorldBuilder& builder, const std::string& name, const RopeSpec& spec)
{
    RopeBuilder rope(builder, spec);
    builder.beginObject(name);
    rope.add();
    return builder.endObject({}, spec.velocity);
}

}  // namespace knuckle
