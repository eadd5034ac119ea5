#include "app/files/actor_mass.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/json/fields.h"
#include "sim/solver/layout/body_mass.h"
#include "sim/world/builder/builder.h"

namespace knuckle {

namespace {

constexpr float EXACT = 1e-3f;  // of masses and inertias, and of the diameter for centres

/// @param exact the largest difference.
void requireNear(const std::string& path, const std::string& pointer, const Json& said, std::span<const float> is,
                 float exact)
{
    size_t at = 0;
    const auto check = [&](const Json& number) {
        if (std::abs(number.get<float>() - is[at]) > exact)
            failAt(path, pointer,
                   fmt::format("has {}, but by its particles {:.4g} at 1000 kg/m3; correct it, or leave it out",
                               number.dump(), is[at]));
        ++at;
    };
    for (const Json& part : said.is_array() ? said : Json::array({said}))
        if (part.is_array()) std::ranges::for_each(part, check);
        else check(part);
}

}  // namespace

std::vector<ActorMass> massesOf(const Actor& actor, float density)
{
    WorldBuilder builder(0.5f * actor.diameter);
    Material material;
    material.density = density;
    addActor(builder, actor, builder.addMaterial(material), {});
    const World world = builder.build();
    std::vector<ActorMass> masses;
    for (const Body& body : world.bodies) {
        const BodyMass mass = bodyMass(world, body);
        const Eigen::Matrix3f moments = mass.moments.cast<float>();
        masses.push_back(
            {static_cast<float>(mass.mass), body.restCentre, moments.trace() * Eigen::Matrix3f::Identity() - moments});
    }
    return masses;
}

void requireMasses(const std::string& path, const Json& root, const Actor& actor)
{
    const auto saysAny = [](const Json& body) {
        return body.contains("mass") || body.contains("centre") || body.contains("inertia");
    };
    if (std::ranges::none_of(root["bodies"], saysAny)) return;
    const std::vector<ActorMass> masses = massesOf(actor);
    for (size_t b = 0; b < masses.size(); ++b) {
        const Json& body = root["bodies"][b];
        const std::string pointer = fmt::format("/bodies/{}/", b);
        const auto& [mass, centre, inertia] = masses[b];
        const auto check = [&](const char* field, std::span<const float> is, float exact) {
            if (body.contains(field)) requireNear(path, pointer + field, body[field], is, exact);
        };
        check("mass", std::span(&mass, 1), EXACT * mass);
        check("centre", std::span(centre.data(), 3), EXACT * actor.diameter);
        check("inertia", std::span(inertia.data(), 9), EXACT * inertia.trace());
    }
}

}  // namespace knuckle
