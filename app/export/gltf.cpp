#include "app/export/gltf.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "app/export/shape_mesh.h"
#include "render/color_word.h"
#include "render/picture/image.h"
#include "render/quantities/color_scale.h"
#include "render/spheres/palette.h"
#include "sim/base/errors.h"
#include "sim/base/files/endings.h"
#include "sim/rig/gltf/glb.h"
#include "sim/rig/skin/skin_mesh.h"

namespace knuckle {

namespace {

constexpr const char* CLIP = "simulation";
// Gives 0.1 mm at the skin: the error of a chain of seven joints of a metre, each at its tolerance.
constexpr float SHIFT_TOLERANCE = 1e-5f;  // [m]
constexpr float TURN_TOLERANCE = 2e-5f;   // [rad]

/// Bodies without a skeleton, a bone each.
Rig rigOfBodies(const World& world, uint32_t object)
{
    Rig rig;
    rig.object = object;
    rig.model.name = world.objects[object].name;
    for (uint32_t b = world.objects[object].bodyStart; b < world.objects[object].bodyEnd(); ++b) {
        Bone bone{world.bodies[b].name};
        bone.restPose.block<3, 1>(0, 3) = world.bodies[b].restCentre;
        rig.model.bones.push_back(bone);
        rig.bodies.push_back(b);
    }
    return rig;
}

/// The mesh that an object wears; null for none.
const SkinMesh* meshOf(const World& world, uint32_t object)
{
    for (const Skin& skin : world.skins)
        if (isDrawn(skin) && std::ranges::find(skin.objects, object) != skin.objects.end()) return skin.mesh.get();
    return nullptr;
}

/// @param rig whose bones are the bodies of an object that wears the mesh.
void addMesh(const SkinMesh& mesh, Rig& rig)
{
    rig.model.triangles = mesh.triangles;
    rig.model.surface.materials = mesh.materials;
    rig.model.surface.textures = mesh.textures;
    for (const SkinVertex& vertex : mesh.vertices) {
        SkinWeights skin;
        std::ranges::copy(vertex.bodies, skin.bones.begin());
        std::ranges::copy(vertex.weights, skin.weights.begin());
        rig.model.vertices.push_back(vertex.position);
        rig.model.skin.push_back(skin);
        rig.model.surface.vertices.push_back({vertex.normal, vertex.uv, vertex.color, vertex.material});
    }
}

/// The first bone that each body moves.
std::map<uint32_t, uint32_t> bonesOfBodies(const Rig& rig)
{
    std::map<uint32_t, uint32_t> bones;
    for (uint32_t b = 0; b < rig.bodies.size(); ++b) bones.emplace(rig.bodies[b], b);
    return bones;
}

/// The colours of drawn particles; per body if colours follow the speed.
std::vector<uint32_t> colorsOf(const Scene& scene)
{
    RenderSettings settings = scene.render;
    if (showsQuantity(settings)) settings.colorBy = ColorBy::Body;
    return particleColors(scene.world, settings);
}

/// A mesh of octahedra at the particles of bodies that have no shape. @param colors of all particles.
void addParticles(Rig& rig, const World& world, const std::vector<uint32_t>& colors, const std::set<uint32_t>& shaped)
{
    const std::map<uint32_t, uint32_t> bones = bonesOfBodies(rig);
    const float radius = world.particleRadius;
    for (size_t i = 0; i < world.particles.size(); ++i) {
        const Particle& particle = world.particles[i];
        const auto bone = bones.find(particle.body);
        if (bone == bones.end() || shaped.contains(particle.body)) continue;
        const auto first = static_cast<uint32_t>(rig.model.vertices.size());
        for (int side = 0; side < 6; ++side) {
            Vector3f offset = Vector3f::Zero();
            offset[side / 2] = side % 2 == 0 ? radius : -radius;
            addRigidVertex(rig, bone->second, particle.restPosition + offset, offset / radius, unpackColor(colors[i]));
        }
        // Corners +x -x +y -y +z -z; counter-clockwise from outside if an even number of signs is negative.
        for (uint32_t octant = 0; octant < 8; ++octant) {
            const uint32_t x = first + (octant & 1u), y = first + 2 + (octant >> 1 & 1u), z = first + 4 + (octant >> 2);
            const bool odd = ((octant & 1u) + (octant >> 1 & 1u) + (octant >> 2)) % 2 == 1;
            rig.model.triangles.push_back({x, odd ? z : y, odd ? y : z});
        }
    }
}

/// For objects without a mesh: bodies as they are drawn, as shapes or as particles.
void addBodies(Rig& rig, const Scene& scene, const std::vector<uint32_t>& colors)
{
    const World& world = scene.world;
    const std::map<uint32_t, uint32_t> bones = bonesOfBodies(rig);
    SkinMaterial material;
    material.name = "bodies";
    material.color = {1, 1, 1};
    material.twoSided = false;
    rig.model.surface = {};
    rig.model.surface.materials = {material};
    std::set<uint32_t> shaped;
    for (const BodyShape& shape : world.bodyShapes) {
        const auto bone = bones.find(shape.body);
        if (bone == bones.end()) continue;
        const uint32_t particle = world.links[world.bodies[shape.body].linkStart].particle;
        addShape(rig, shape, bone->second, unpackColor(colors[particle]));
        shaped.insert(shape.body);
    }
    addParticles(rig, world, colors, shaped);
}

/// Makes one bone of each body do the work of all its bones, so that four bones are four bodies.
void mergeWeights(Rig& rig)
{
    const std::map<uint32_t, uint32_t> bones = bonesOfBodies(rig);
    std::vector<uint32_t> owners;
    for (const uint32_t body : rig.bodies) owners.push_back(bones.at(body));
    for (SkinWeights& skin : rig.model.skin) {
        SkinWeights merged;
        size_t i = 0;
        for (const auto& [bone, weight] : weightsByOwner(skin, owners)) {
            merged.bones[i] = bone;
            merged.weights[i++] = weight;
        }
        skin = merged;
    }
}

std::vector<Rig> everyRig(const Scene& scene)
{
    std::vector<Rig> rigs = rigsOf(scene, true);
    const std::vector<uint32_t> colors = colorsOf(scene);
    for (Rig& rig : rigs) {
        // A mesh that import made up around bones does not belong to the file.
        if (rig.model.surface.vertices.empty()) {
            rig.model.vertices.clear();
            rig.model.triangles.clear();
            rig.model.skin.clear();
            addBodies(rig, scene, colors);
        } else mergeWeights(rig);
    }
    for (uint32_t object = 0; object < scene.world.objects.size(); ++object) {
        if (scene.world.objects[object].bodyCount == 0) continue;
        if (std::ranges::find(rigs, object, &Rig::object) != rigs.end()) continue;
        rigs.push_back(rigOfBodies(scene.world, object));
        if (const SkinMesh* mesh = meshOf(scene.world, object)) addMesh(*mesh, rigs.back());
        else addBodies(rigs.back(), scene, colors);
    }
    std::ranges::stable_sort(rigs, {}, &Rig::object);
    for (Rig& rig : rigs) rig.model.clips = {{CLIP, 0.0, {}, {}, {}}};
    return rigs;
}

std::string encodePicture(const TexturePicture& picture)
{
    return encodePng(picture.width, picture.height, 4, picture.rgba);
}

}  // namespace

GltfExport::GltfExport(const std::string& path) : Exporter(path)
{
    if (endingOf(path) == ".gltf")
        throw InputError(fmt::format("--export gltf={}: it is written as binary glTF; name it {}", path,
                                     std::filesystem::path(path).replace_extension(".glb").string()));
}

void GltfExport::begin(const Scene& scene)
{
    framesPerSecond_ = scene.framesPerSecond;
    rigs_ = everyRig(scene);
    file_.emplace(path());
    if (rigs_.empty())
        throw InputError(fmt::format("--export gltf={}: the scene has no bodies, which could be written", path()));
}

std::vector<std::string> GltfExport::leftOut(const World& world) const
{
    std::vector<bool> isTied(world.particles.size(), false);
    for (const Strand& strand : world.strands)
        for (const uint32_t particle : strand.particles) isTied[particle] = true;
    bool hasGrains = false;
    for (uint32_t i = 0; i < world.solidCount(); ++i) {
        const Particle& particle = world.particles[i];
        hasGrains = hasGrains || (particle.bodyCount == 0 && particle.assembly == NO_INDEX && !isTied[i]);
    }
    std::vector<std::string> names;
    for (const auto& [name, isThere] :
         {std::pair{"colliders", !world.colliders.empty()}, std::pair{"soft bodies", !world.softBodies.empty()},
          std::pair{"ropes and cloth", !world.strands.empty()}, std::pair{"grains", hasGrains},
          std::pair{"fluids", world.fluidCount > 0}})
        if (isThere) names.emplace_back(name);
    return names;
}

void GltfExport::frame(const ExportFrame& frame)
{
    for (Rig& rig : rigs_) {
        std::vector<Eigen::Matrix4f> poses;
        for (size_t b = 0; b < rig.bodies.size(); ++b) {
            const uint32_t body = rig.bodies[b];
            poses.push_back(motionOf(frame.world.bodies[body], (*frame.bodies)[body]).matrix() *
                            rig.model.bones[b].restPose);
        }
        rig.model.clips[0].poses.push_back(std::move(poses));
    }
}

void GltfExport::finish()
{
    std::vector<Model> models;
    for (Rig& rig : rigs_) {
        Clip& clip = rig.model.clips[0];
        for (size_t k = 0; k < clip.poses.size(); ++k)
            clip.keyTimes.push_back(static_cast<double>(k) / framesPerSecond_);
        models.push_back(std::move(rig.model));
    }
    GlbOptions options;
    options.shiftTolerance = SHIFT_TOLERANCE;
    options.turnTolerance = TURN_TOLERANCE;
    options.apart = true;
    options.encode = encodePicture;
    file_->write(toGlb(models, options));
    file_->commit();
}

}  // namespace knuckle
