#include "app/files/actor_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

#include "app/json/fields.h"
#include "app/json/json.h"
#include "sim/base/errors.h"
#include "sim/rig/particle_owners.h"

namespace knuckle {

namespace {

/// Nearer particles are at one place: no solid has such, and contacts between them have no direction [diameters].
constexpr float NEAREST = 0.1f;
/// Of the axis of a hinge along the line of its particles: the cosine of 18 degrees.
constexpr float ALONG = 0.95f;

void checkSurface(const std::string& path, const Actor& actor)
{
    if (!actor.signedDistances.empty() && actor.signedDistances.size() != actor.particles.size()) {
        failAt(path, "/signedDistances",
               fmt::format("has {} entries for {} particles; give one each or none", actor.signedDistances.size(),
                           actor.particles.size()));
    }
    if (!actor.outward.empty() && actor.outward.size() != actor.signedDistances.size()) {
        failAt(path, "/outward",
               fmt::format("has {} entries for {} signedDistances; give one each or none", actor.outward.size(),
                           actor.signedDistances.size()));
    }
    for (size_t i = 0; i < actor.outward.size(); ++i) {
        const float length = actor.outward[i].norm();
        if (length != 0.0f && std::abs(length - 1.0f) > 1e-3f)
            failAt(path, fmt::format("/outward/{}", i), fmt::format("has a length of {}; must be 1 or 0", length));
    }
}

void checkOwners(const std::string& path, const Actor& actor)
{
    for (size_t b = 0; b < actor.bodies.size(); ++b) {
        std::set<uint32_t> listed;
        const std::vector<uint32_t>& particles = actor.bodies[b].particles;
        for (size_t i = 0; i < particles.size(); ++i)
            if (!listed.insert(particles[i]).second)
                failAt(path, fmt::format("/bodies/{}/particles/{}", b, i),
                       fmt::format("particle {} is in this list already; remove it", particles[i]));
    }
    const std::vector<uint32_t> owners = particleOwners(actor);
    const auto unused = std::ranges::find(owners, NO_INDEX);
    if (unused != owners.end())
        failAt(path, fmt::format("/particles/{}", unused - owners.begin()), "belongs to no body; remove it");
    for (uint32_t b = 0; b < actor.bodies.size(); ++b)
        if (std::ranges::find(owners, b) == owners.end())
            failAt(path, fmt::format("/bodies/{}/particles", b),
                   "other bodies share all of them; add one that is the body's own");
}

/// Checks that no two particles are at one place, with cells that are as long as they must be apart.
void checkPlaces(const std::string& path, const Actor& actor)
{
    const float least = NEAREST * actor.diameter;
    using Cell = Eigen::Array<int64_t, 3, 1>;
    const auto keyOf = [](const Cell& cell) {
        // A collision only costs a comparison.
        return static_cast<uint64_t>(cell.x() * 73856093 ^ cell.y() * 19349663 ^ cell.z() * 83492791);
    };
    std::unordered_multimap<uint64_t, uint32_t> placed;
    for (uint32_t p = 0; p < actor.particles.size(); ++p) {
        const Vector3f& place = actor.particles[p];
        const Cell cell = (place.cast<double>() / double{least}).array().floor().cast<int64_t>();
        for (int64_t k = 0; k < 27; ++k) {
            const auto [first, last] = placed.equal_range(keyOf(cell + Cell{k % 3, k / 3 % 3, k / 9} - 1));
            for (auto found = first; found != last; ++found) {
                const float distance = (actor.particles[found->second] - place).norm();
                if (distance >= least) continue;
                failAt(path, fmt::format("/particles/{}", p),
                       fmt::format("is {:.3g} m from particle {}, nearer than a tenth of the diameter, {:g} m; remove "
                                   "one, or let bodies share it",
                                   distance, found->second, actor.diameter));
            }
        }
        placed.emplace(keyOf(cell), p);
    }
}

void checkLimited(const std::string& path, const Actor& actor, size_t index)
{
    const ActorJoint& joint = actor.joints[index];
    if (!joint.limits.any()) return;
    if (joint.axis.norm() < 1e-3f)
        failAt(path, fmt::format("/joints/{}/axis", index), "must not be zero, since limits are angles about it");
    const int32_t parent = actor.bodies[joint.child].parent;
    if (parent != static_cast<int32_t>(joint.parent))
        failAt(path, fmt::format("/bodies/{}/parent", joint.child),
               fmt::format("is {}, but joint {} with limits hangs the body on {}; make both the same, or leave the "
                           "limits out",
                           parent, index, joint.parent));
}

void checkJoints(const std::string& path, const Actor& actor)
{
    for (size_t j = 0; j < actor.joints.size(); ++j) {
        const ActorJoint& joint = actor.joints[j];
        const std::string pointer = fmt::format("/joints/{}", j);
        if (joint.parent == joint.child)
            failAt(path, pointer + "/child", fmt::format("{} is the parent, too; name another body", joint.child));
        for (size_t i = 0; i < joint.sharedParticles.size(); ++i)
            for (const uint32_t body : {joint.parent, joint.child})
                if (const uint32_t particle = joint.sharedParticles[i];
                    std::ranges::find(actor.bodies[body].particles, particle) == actor.bodies[body].particles.end())
                    failAt(path, fmt::format("{}/sharedParticles/{}", pointer, i),
                           fmt::format("particle {} is not in body {} (\"{}\"), so it does not hold it; add it to "
                                       "/bodies/{}/particles, or name one of both bodies",
                                       particle, body, actor.bodies[body].name, body));
        checkLimited(path, actor, j);
    }
}

/// How particles of a joint of some type lie.
const char* arrangementOf(JointType type)
{
    return std::array{"at one place", "in a line", "in a plane or in space"}.at(static_cast<size_t>(type));
}

void addNameWarnings(const Actor& actor, std::vector<std::string>& warnings)
{
    std::map<std::string, size_t> known;
    for (size_t b = 0; b < actor.bodies.size(); ++b) {
        const auto [first, isNew] = known.emplace(actor.bodies[b].name, b);
        if (!isNew)
            warnings.push_back(fmt::format("/bodies/{}/name: body {} is \"{}\", too, so a scene cannot name one of "
                                           "them alone; rename one",
                                           b, first->second, first->first));
    }
}

void addJointWarnings(const Actor& actor, const World& world, std::vector<std::string>& warnings)
{
    for (size_t j = 0; j < actor.joints.size(); ++j) {
        const ActorJoint& joint = actor.joints[j];
        const JointType said = joint.type == JointType::Universal ? JointType::Hinge : joint.type;
        const auto built = std::ranges::find_if(
            world.joints, [&](const Joint& other) { return other.connects(joint.parent, joint.child); });
        if (built->type != said) {
            warnings.push_back(fmt::format("/joints/{}/type: the bodies share particles {}, which makes a {} joint, "
                                           "not a {} one; that shares particles {}",
                                           j, arrangementOf(built->type), wordOf(built->type), wordOf(said),
                                           arrangementOf(said)));
        } else if (said == JointType::Hinge) {
            const Vector3f line = built->childSide.frame * Vector3f::UnitX();
            if (std::abs(line.dot(joint.axis)) < ALONG)
                warnings.push_back(fmt::format("/joints/{}/axis: the hinge turns about the line of its particles, "
                                               "({:.2f} {:.2f} {:.2f}), not about this; make it the same",
                                               j, line.x(), line.y(), line.z()));
        }
    }
}

}  // namespace

void requireConsistent(const std::string& path, const Actor& actor)
{
    checkSurface(path, actor);
    checkOwners(path, actor);
    checkJoints(path, actor);
    checkPlaces(path, actor);
}

World worldOf(const std::string& path, const Actor& actor)
{
    try {
        WorldBuilder builder(0.5f * actor.diameter);
        addActor(builder, actor, builder.addMaterial({}), {});
        return builder.build();
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", path, error.what()));
    }
}

void requireUsable(const std::string& file, const Actor& actor)
{
    const size_t count = actor.particles.size();
    if (count < FEWEST_PARTICLES)
        throw InputError(
            fmt::format("{}: {} particle{} of {:.3g} m are too few for an actor; use --particles 1000, or a smaller "
                        "--diameter",
                        file, count, count == 1 ? "" : "s", actor.diameter));
    if (actor.diameter < static_cast<float>(SMALLEST_DIAMETER))
        throw InputError(
            fmt::format("{}: it would consist of particles of {:.3g} m, scenes have some of {:g} m or more; "
                        "make it larger by --height, or use fewer --particles",
                        file, actor.diameter, SMALLEST_DIAMETER));
    worldOf(file, actor);
}

std::vector<std::string> actorWarnings(const Actor& actor, const World& world)
{
    std::vector<std::string> warnings;
    addNameWarnings(actor, warnings);
    addJointWarnings(actor, world, warnings);
    return warnings;
}

}  // namespace knuckle
