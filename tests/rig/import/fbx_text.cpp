#include "tests/rig/import/fbx_text.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <numbers>

namespace knuckle::test {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;

namespace {

constexpr long long SECOND = 46186158000;

std::string property(const char* name, const char* type, const std::optional<Vector3d>& v)
{
    return v ? fmt::format("P: \"{}\", \"{}\", \"\", \"A\",{:.9g},{:.9g},{:.9g}\n", name, type, v->x(), v->y(), v->z())
             : "";
}

std::string property(const char* name, const std::optional<int>& v)
{
    return v ? fmt::format("P: \"{}\", \"enum\", \"\", \"\",{}\n", name, *v) : "";
}

std::string model(const FbxJoint& j, size_t id)
{
    const std::string turned = j.preRotation || j.postRotation || j.order
                                   ? "P: \"RotationActive\", \"bool\", \"\", \"\",1\n"
                                   : "";
    return fmt::format("NodeAttribute: {}, \"NodeAttribute::{}\", \"LimbNode\" {{\nTypeFlags: \"Skeleton\"\n}}\n"
                       "Model: {}, \"Model::{}\", \"LimbNode\" {{\nVersion: 232\nProperties70:  {{\n",
                       2000 + id, j.name, 1000 + id, j.name) +
           turned + property("RotationOrder", j.order) + property("InheritType", j.inherit) +
           property("RotationOffset", "Vector3D", j.rotationOffset) +
           property("RotationPivot", "Vector3D", j.rotationPivot) +
           property("ScalingOffset", "Vector3D", j.scalingOffset) +
           property("ScalingPivot", "Vector3D", j.scalingPivot) + property("PreRotation", "Vector3D", j.preRotation) +
           property("PostRotation", "Vector3D", j.postRotation) +
           property("Lcl Translation", "Lcl Translation", j.translation) +
           property("Lcl Rotation", "Lcl Rotation", j.rotation) + property("Lcl Scaling", "Lcl Scaling", j.scaling) +
           "}\n}\n";
}

/// Additions to a file by an animated property: objects and their connections.
struct Curves {
    std::string objects, connections;
    size_t next = 6000;

    /// @param axes that have curves.
    void add(const std::vector<Vector3d>& keys, const std::string& axes, size_t owner, const char* letter,
             const char* target)
    {
        if (keys.empty()) return;
        const size_t node = next++;
        objects += fmt::format("AnimationCurveNode: {}, \"AnimCurveNode::{}\", \"\" {{\nProperties70:  {{\n", node,
                               letter);
        for (int axis = 0; axis < 3; ++axis)
            objects += fmt::format("P: \"d|{}\", \"Number\", \"\", \"A\",{:.9g}\n", "XYZ"[axis], keys[0][axis]);
        objects += "}\n}\n";
        connections += fmt::format("C: \"OO\",{},5001\nC: \"OP\",{},{}, \"{}\"\n", node, node, owner, target);
        for (int axis = 0; axis < 3; ++axis) {
            if (axes.find("xyz"[axis]) == std::string::npos) continue;
            std::string times, values;
            for (size_t k = 0; k < keys.size(); ++k) {
                times += fmt::format("{}{}", k > 0 ? "," : "", static_cast<long long>(k) * SECOND / 2);
                values += fmt::format("{}{:.9g}", k > 0 ? "," : "", keys[k][axis]);
            }
            objects += fmt::format(
                "AnimationCurve: {}, \"AnimCurve::\", \"\" {{\nDefault: 0\nKeyVer: 4009\nKeyTime: *{} {{\na: {}\n}}\n"
                "KeyValueFloat: *{} {{\na: {}\n}}\nKeyAttrFlags: *1 {{\na: 4\n}}\nKeyAttrDataFloat: *4 {{\n"
                "a: 0,0,0,0\n}}\nKeyAttrRefCount: *1 {{\na: {}\n}}\n}}\n",
                next, keys.size(), times, keys.size(), values, keys.size());
            connections += fmt::format("C: \"OP\",{},{}, \"d|{}\"\n", next++, node, "XYZ"[axis]);
        }
    }
};

Matrix3d turn(const Vector3d& degrees, int order)
{
    const Vector3d radians = degrees * std::numbers::pi / 180.0;
    Matrix3d about[3];
    for (int axis = 0; axis < 3; ++axis)
        about[axis] = Eigen::AngleAxisd(radians[axis], Vector3d::Unit(axis)).toRotationMatrix();
    constexpr int FIRST_TO_LAST[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {1, 0, 2}, {2, 0, 1}, {2, 1, 0}};
    const int(&o)[3] = FIRST_TO_LAST[order];
    return about[o[2]] * about[o[1]] * about[o[0]];
}

Matrix4d moved(const std::optional<Vector3d>& by, double sign = 1.0)
{
    Matrix4d m = Matrix4d::Identity();
    if (by) m.topRightCorner<3, 1>() = sign * *by;
    return m;
}

Matrix4d linear(const Matrix3d& matrix)
{
    Matrix4d m = Matrix4d::Identity();
    m.topLeftCorner<3, 3>() = matrix;
    return m;
}

}  // namespace

std::string fbxText(const std::vector<FbxJoint>& joints)
{
    std::string objects, connections;
    Curves curves;
    for (size_t id = 0; id < joints.size(); ++id) {
        const FbxJoint& j = joints[id];
        objects += model(j, id);
        connections += fmt::format("C: \"OO\",{},{}\nC: \"OO\",{},{}\n", 1000 + id, j.parent < 0 ? 0 : 1000 + j.parent,
                                   2000 + id, 1000 + id);
        curves.add(j.turns, j.turnAxes, 1000 + id, "R", "Lcl Rotation");
        curves.add(j.moves, j.moveAxes, 1000 + id, "T", "Lcl Translation");
    }
    return "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\nFBXHeaderVersion: 1003\nFBXVersion: 7400\n}\n"
           "GlobalSettings:  {\nVersion: 1000\nProperties70:  {\nP: \"UpAxis\", \"int\", \"Integer\", \"\",1\n"
           "P: \"UnitScaleFactor\", \"double\", \"Number\", \"\",100\nP: \"TimeMode\", \"enum\", \"\", \"\",6\n}\n}\n"
           "Definitions:  {\nVersion: 100\nCount: 1\n}\nObjects:  {\n" +
           objects +
           "AnimationStack: 5000, \"AnimStack::clip\", \"\" {\n}\nAnimationLayer: 5001, \"AnimLayer::Base\", \"\" "
           "{\n}\n" +
           curves.objects + "}\nConnections:  {\n" + connections + "C: \"OO\",5001,5000\n" + curves.connections + "}\n";
}

std::vector<Matrix4d> fbxPose(const std::vector<FbxJoint>& joints, size_t key)
{
    struct Global {
        Matrix4d all = Matrix4d::Identity();
        Matrix3d rotation = Matrix3d::Identity(), scale = Matrix3d::Identity(), own = Matrix3d::Identity();
    };
    std::vector<Global> globals;
    std::vector<Matrix4d> out;
    const Vector3d zero(0, 0, 0), one(1, 1, 1);
    for (const FbxJoint& j : joints) {
        const Vector3d angles = j.turns.empty() ? j.rotation.value_or(zero) : j.turns[key];
        const Matrix3d rotation = turn(j.preRotation.value_or(zero), 0) * turn(angles, j.order.value_or(0)) *
                                  turn(j.postRotation.value_or(zero), 0).transpose();
        const Matrix3d scale = j.scaling.value_or(one).asDiagonal();
        const Matrix4d local = moved(j.moves.empty() ? j.translation : j.moves[key]) * moved(j.rotationOffset) *
                               moved(j.rotationPivot) * linear(rotation) * moved(j.rotationPivot, -1.0) *
                               moved(j.scalingOffset) * moved(j.scalingPivot) * linear(scale) *
                               moved(j.scalingPivot, -1.0);
        const Global parent = j.parent < 0 ? Global{} : globals[static_cast<size_t>(j.parent)];
        Global global{parent.all * local, parent.rotation * rotation, {}, scale};
        Matrix3d both;
        const int inherit = j.inherit.value_or(1);
        if (inherit == 0) both = parent.rotation * rotation * parent.scale * scale;
        if (inherit == 1) both = parent.rotation * parent.scale * rotation * scale;
        if (inherit == 2) both = parent.rotation * rotation * parent.scale * parent.own.inverse() * scale;
        global.all.topLeftCorner<3, 3>() = both;
        global.scale = global.rotation.transpose() * both;
        globals.push_back(global);
        out.push_back(global.all);
    }
    return out;
}

}  // namespace knuckle::test
