#include "tests/rig/anatomy/rigs.h"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace knuckle::test {

namespace {

/// The start of each part of the left side, of a figure of 1.75 m that faces +z.
const std::map<std::string, Eigen::Vector3f> PLACES = {
    {"hips", {0, 0.95f, 0}},        {"spine", {0, 1.05f, 0}},        {"neck", {0, 1.45f, 0}},
    {"head", {0, 1.55f, 0}},        {"clavicle", {0.04f, 1.41f, 0}}, {"upperArm", {0.18f, 1.40f, 0}},
    {"forearm", {0.45f, 1.40f, 0}}, {"hand", {0.70f, 1.40f, 0}},     {"finger", {0.80f, 1.40f, 0.02f}},
    {"thigh", {0.10f, 0.91f, 0}},   {"shin", {0.11f, 0.50f, 0.01f}}, {"foot", {0.12f, 0.09f, -0.02f}},
    {"toe", {0.12f, 0.02f, 0.12f}},
};

std::string trimmed(const std::string& text)
{
    const size_t first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::string withSide(std::string text, const std::string& side)
{
    for (size_t at = text.find("{}"); at != std::string::npos; at = text.find("{}")) text.replace(at, 2, side);
    return text;
}

void addChain(Rig& rig, const std::string& chain, int side)
{
    int32_t parent = -1;
    for (size_t from = 0; from <= chain.size();) {
        const size_t end = std::min(chain.find('>', from), chain.size());
        const std::string item = trimmed(chain.substr(from, end - from));
        from = end + 1;
        const size_t equals = item.find('=');
        const std::string name = item.substr(0, equals);
        if (equals == std::string::npos) {
            parent = static_cast<int32_t>(rig.find(name));
            continue;
        }
        const std::string is = item.substr(equals + 1);
        Eigen::Vector3f head(0, 1, 0);
        if (parent >= 0) head = rig.model.bones[parent].restPose.block<3, 1>(0, 3) + Eigen::Vector3f(0, 0.03f, 0);
        const auto place = PLACES.find(is);
        const bool again = parent >= 0 && rig.expected[parent] == is;
        if (place != PLACES.end() && !again) {
            head = place->second;
            if (side < 0) head.x() = -head.x();
        }
        parent = static_cast<int32_t>(rig.add(name, parent, head, is, side));
    }
}

}  // namespace

uint32_t Rig::add(const std::string& name, int32_t parent, const Eigen::Vector3f& head, const std::string& is, int side)
{
    Bone bone{name, parent};
    bone.restPose.block<3, 1>(0, 3) = head;
    model.bones.push_back(bone);
    expected.push_back(is);
    sides.push_back(side);
    const auto index = static_cast<uint32_t>(model.bones.size() - 1);
    SkinWeights skin;
    skin.bones[0] = index;
    skin.weights[0] = is == "control" ? 0.0f : 1.0f;
    model.vertices.push_back(head);
    model.skin.push_back(skin);
    return index;
}

uint32_t Rig::find(const std::string& name) const
{
    const auto found = std::ranges::find(model.bones, name, &Bone::name);
    if (found == model.bones.end()) throw std::logic_error("no bone is called " + name);
    return static_cast<uint32_t>(found - model.bones.begin());
}

Rig makeRig(const Convention& convention)
{
    Rig rig;
    for (const std::string& chain : convention.chains) {
        const bool sided = chain.find("{}") != std::string::npos;
        addChain(rig, withSide(chain, convention.left), sided ? 1 : 0);
        if (sided) addChain(rig, withSide(chain, convention.right), -1);
    }
    return rig;
}

}  // namespace knuckle::test
