#include "tests/rig/figures/box_figure.h"

#include <algorithm>
#include <stdexcept>

#include "tests/rig/shapes.h"

namespace knuckle::test {

namespace {

constexpr struct {
    const char* name;
    float x;
} SIDES[] = {{".L", 1.0f}, {".R", -1.0f}};

void addBox(Model& model, uint32_t bone, const Vector3f& centre, const Vector3f& half)
{
    const TriangleMesh box = boxMesh(centre, half);
    const auto first = static_cast<uint32_t>(model.vertices.size());
    for (const Vector3f& vertex : box.vertices) {
        model.vertices.push_back(vertex);
        model.skin.push_back({{bone}, {1.0f}});
    }
    for (const Triangle& t : box.triangles) model.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

template <typename List, typename Name>
auto& named(List& list, const std::string& name, Name field)
{
    const auto found = std::ranges::find(list, name, field);
    if (found == list.end()) throw std::out_of_range("nothing is called " + name);
    return *found;
}

}  // namespace

Model boxFigure(const BoxBones& bones)
{
    Model model;
    model.name = "figure";
    std::vector<std::string> placed;
    // Parents come first in a model.
    while (placed.size() < bones.size()) {
        const size_t before = placed.size();
        for (const BoxBone& bone : bones) {
            const auto parent = std::ranges::find(placed, bone.parent);
            if ((parent == placed.end() && !bone.parent.empty()) || std::ranges::count(placed, bone.name) > 0) continue;
            const auto index = static_cast<uint32_t>(placed.size());
            Bone made{bone.name, bone.parent.empty() ? -1 : static_cast<int32_t>(parent - placed.begin())};
            made.restPose.block<3, 1>(0, 3) = bone.head;
            model.bones.push_back(made);
            placed.push_back(bone.name);
            if (!bone.half.isZero()) addBox(model, index, bone.centre, bone.half);
        }
        if (placed.size() == before) throw std::logic_error("a parent is missing");
    }
    return model;
}

BoxBones boxPerson()
{
    BoxBones bones{{"hips", "", {0, 0.95f, 0}, {0, 1.0f, 0}, {0.14f, 0.12f, 0.1f}},
                   {"spine", "hips", {0, 1.1f, 0}, {0, 1.25f, 0}, {0.15f, 0.15f, 0.1f}},
                   {"head", "spine", {0, 1.45f, 0}, {0, 1.58f, 0}, {0.1f, 0.13f, 0.11f}}};
    for (const auto& [side, x] : SIDES) {
        const auto add = [&bones, s = std::string(side), x = x](const std::string& name, const std::string& parent,
                                                                const Vector3f& head, const Vector3f& centre,
                                                                const Vector3f& half) {
            const bool trunk = parent == "hips" || parent == "spine";
            const Vector3f mirror(x, 1, 1);
            bones.push_back(
                {name + s, trunk ? parent : parent + s, head.cwiseProduct(mirror), centre.cwiseProduct(mirror), half});
        };
        add("thigh", "hips", {0.09f, 0.88f, 0}, {0.09f, 0.68f, 0}, {0.07f, 0.19f, 0.07f});
        add("shin", "thigh", {0.09f, 0.48f, 0}, {0.09f, 0.28f, 0}, {0.055f, 0.19f, 0.055f});
        add("foot", "shin", {0.09f, 0.08f, 0}, {0.09f, 0.04f, 0.06f}, {0.05f, 0.04f, 0.12f});
        add("upper_arm", "spine", {0.18f, 1.35f, 0}, {0.31f, 1.35f, 0}, {0.13f, 0.045f, 0.045f});
        add("forearm", "upper_arm", {0.45f, 1.35f, 0}, {0.57f, 1.35f, 0}, {0.12f, 0.04f, 0.04f});
    }
    return bones;
}

BoxBones boxDog()
{
    BoxBones bones{{"root", "", {0, 0, 0}},
                   {"Hips", "root", {0, 0.58f, -0.2f}, {0, 0.58f, -0.2f}, {0.12f, 0.12f, 0.2f}},
                   {"Torso", "Hips", {0, 0.58f, 0.05f}, {0, 0.58f, 0.22f}, {0.13f, 0.13f, 0.2f}},
                   {"Neck", "Torso", {0, 0.66f, 0.44f}, {0, 0.74f, 0.5f}, {0.06f, 0.1f, 0.07f}},
                   {"Head", "Neck", {0, 0.84f, 0.55f}, {0, 0.88f, 0.66f}, {0.08f, 0.08f, 0.14f}},
                   {"Tail", "Hips", {0, 0.64f, -0.44f}, {0, 0.64f, -0.56f}, {0.03f, 0.03f, 0.12f}}};
    for (const auto& [side, x] : SIDES) {
        for (const bool front : {true, false}) {
            const std::string leg = front ? "Front" : "Back";
            const float z = front ? 0.34f : -0.34f, at = 0.1f * x;
            bones.push_back(
                {leg + "Leg" + side, front ? "Torso" : "Hips", {at, 0.5f, z}, {at, 0.4f, z}, {0.05f, 0.1f, 0.06f}});
            bones.push_back({leg + "LowLeg" + side,
                             leg + "Leg" + side,
                             {at, 0.3f, z - 0.02f},
                             {at, 0.18f, z - 0.02f},
                             {0.04f, 0.12f, 0.04f}});
            bones.push_back({leg + "Foot" + side,
                             leg + "LowLeg" + side,
                             {at, 0.06f, z - 0.02f},
                             {at, 0.03f, z + 0.03f},
                             {0.045f, 0.03f, 0.08f}});
        }
    }
    return bones;
}

BoxBone& boneOf(BoxBones& bones, const std::string& name)
{
    return named(bones, name, &BoxBone::name);
}

uint32_t indexOf(const Model& model, const std::string& bone)
{
    return static_cast<uint32_t>(&named(model.bones, bone, &Bone::name) - model.bones.data());
}

std::string ownerOf(const Model& model, const std::string& bone)
{
    const int32_t owner = readAnatomy(model)[indexOf(model, bone)].parent;
    return owner < 0 ? "nothing" : model.bones[static_cast<size_t>(owner)].name;
}

std::string parentOf(const Actor& actor, const std::string& body)
{
    const auto found = std::ranges::find(actor.bodies, body, &ActorBody::name);
    if (found == actor.bodies.end()) return "no body";
    return found->parent < 0 ? "none" : actor.bodies[static_cast<size_t>(found->parent)].name;
}

const ActorJoint& jointOf(const Actor& actor, const std::string& name)
{
    return named(actor.joints, name, &ActorJoint::name);
}

const ActorBody& bodyOf(const Actor& actor, const std::string& name)
{
    return named(actor.bodies, name, &ActorBody::name);
}

}  // namespace knuckle::test
