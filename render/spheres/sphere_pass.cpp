#include "render/spheres/sphere_pass.h"

#include <span>
#include <vector>

#include "render/fluids/fluid_looks.h"
#include "render/looks/finishes.h"
#include "render/looks/picture_defines.h"
#include "render/quantities/color_scale.h"
#include "render/spheres/palette.h"

namespace knuckle {

namespace {

/// Loose particles with patterns of their own.
constexpr uint32_t LOOSE_PLACES = 512;

/// The axis along which each body's particles reach furthest.
std::vector<uint32_t> longestAxes(const World& world)
{
    std::vector<uint32_t> axes;
    for (const Body& body : world.bodies) {
        Eigen::AlignedBox3f box;
        for (const Link& link : std::span(world.links).subspan(body.linkStart, body.linkCount))
            box.extend(link.restOffset);
        // Of equal ones the first.
        Vector3f sides = Vector3f::Zero();
        if (!box.isEmpty()) sides = (box.sizes() / world.particleRadius).array().round().matrix();
        Eigen::Index axis = 0;
        sides.maxCoeff(&axis);
        axes.push_back(static_cast<uint32_t>(axis));
    }
    return axes;
}

/// Where each is in its first body, w: 4 times that body and its longest axis; loose ones are apart from each other,
/// w: -1.
std::vector<gpu::vec4> placesOf(const World& world)
{
    std::vector<gpu::vec4> places;
    for (uint32_t i = 0; i < world.particles.size(); ++i) {
        const float apart = static_cast<float>(i % LOOSE_PLACES) * 7.31f * world.particleRadius;
        places.push_back({apart, 0.37f * apart, 0.73f * apart, -1.0f});
    }
    const std::vector<uint32_t> axes = longestAxes(world);
    for (const Link& link : world.links) {
        if (world.particles[link.particle].body != link.body) continue;
        const Vector3f& at = link.restOffset;
        places[link.particle] = {at.x(), at.y(), at.z(), static_cast<float>(4 * link.body + axes[link.body])};
    }
    return places;
}

/// A bit per particle that is drawn as a grain.
std::vector<uint32_t> grainBits(const World& world)
{
    std::vector<uint32_t> bits(world.particles.size() / 32 + 1, 0);
    for (const ParticleRange& range : world.drawn.grains)
        for (uint32_t grain = range.first; grain < range.end; ++grain) bits[grain / 32] |= 1u << grain % 32;
    return bits;
}

}  // namespace

SpherePass::SpherePass(const Gpu& gpu, BufferTable& table, const World& world, const RenderSettings& settings,
                       const RenderTargets& targets)
    : colors_("sphereColors", particleColors(world, settings)),
      grains_("grainParticles", std::span<const uint32_t>(grainBits(world)))
{
    table.add(Lifetime::Constant, colors_, grains_);
    const Defines patterns = Finishes(world).patternDefines();
    const std::vector<gpu::vec4> places = patterns.empty() ? std::vector<gpu::vec4>() : placesOf(world);
    places_ = {"spherePlaces", std::span<const gpu::vec4>(places)};
    table.add(Lifetime::Constant, places_);
    const auto passes = [&](const Defines& more, bool apart) {
        Defines defines = colorDefines(world, settings);
        defines.insert(defines.end(), patterns.begin(), patterns.end());
        defines.insert(defines.end(), more.begin(), more.end());
        const Defines seen = joined({defines, targets.layerDefines()});
        std::vector<std::string> reads = {"sphereList",    "sphereScales",   "positions",      "velocities",
                                          "sphereColors",  "spherePlaces",   "grainParticles", "finishes",
                                          "bodyRotations", "shownQuantities"};
        if (apart) reads.push_back("fluidMaterials");
        const auto pass = [&](const char* vertex, const char* fragment, const Framebuffer& target) {
            const Defines& own = &target == &targets.geometry ? seen : defines;
            return DrawPass(gpu, table, {vertex, fragment, own}, reads, target);
        };
        return Passes{pass("spheres/sphere", "spheres/sphere", targets.geometry),
                      pass("spheres/sphere_quad", "spheres/sphere", targets.geometry),
                      pass("spheres/sphere_shadow", "spheres/sphere_shadow", targets.shadowMap)};
    };
    all_ = passes(world.drawn.grains.empty() ? Defines{} : Defines{{"GRAINS", "1"}}, false);
    if (targets.hasSurfaces() && drawsFluids(world, settings, DrawnAs::Particles))
        beads_ = passes({{"BEADS", "1"}}, true);
}

const SpherePass::Passes& SpherePass::of(SphereGroup group) const
{
    return group == SphereGroup::Fluid && beads_ ? *beads_ : all_;
}

void SpherePass::drawShadow(KernelTimer& timer, const SphereLists& lists, SphereGroup group) const
{
    lists.draw(timer, of(group).shadow, group, SHADOW_DRAW);
}

void SpherePass::draw(KernelTimer& timer, const SphereLists& lists, SphereGroup group) const
{
    lists.draw(timer, of(group).points, group, POINT_DRAW);
    lists.draw(timer, of(group).quads, group, QUAD_DRAW);
}

float pointSizeLimit()
{
    GLfloat range[2] = {1, 1};
    glGetFloatv(GL_POINT_SIZE_RANGE, range);
    return range[1];
}

}  // namespace knuckle
