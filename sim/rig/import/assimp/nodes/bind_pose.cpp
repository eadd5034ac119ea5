#include "sim/rig/import/assimp/nodes/bind_pose.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "sim/rig/import/assimp/nodes/shown_meshes.h"

namespace knuckle {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;

namespace {

constexpr size_t FEWEST = 4;         // bones that make a pose
constexpr double TURNED = 0.15;      // a bone turned by more against its parent is in another pose [rad]
constexpr size_t FEWEST_TURNED = 2;  // bones
constexpr double SAME_SCALE = 0.02;  // largest difference between a node's scale and that of its bind matrix
constexpr double BETTER = 0.05;      // of the size: how much better a place in the scene has to fit

Vector3d placeOf(const Matrix4d& m)
{
    return m.block<3, 1>(0, 3);
}

Matrix3d turnOf(const Matrix4d& m)
{
    return m.topLeftCorner<3, 3>().colwise().normalized();
}

double angleBetween(const Matrix3d& a, const Matrix3d& b)
{
    return std::acos(std::clamp(0.5 * ((a.transpose() * b).trace() - 1.0), -1.0, 1.0));
}

/// Where the bones of one mesh are when it is bound, in its own space, by node.
using Bind = std::map<uint32_t, Matrix4d>;

/// Empty if the matrices are no pose: not finite, flat, or all the same.
Bind bindOf(const aiMesh& mesh, const NodeTable& table)
{
    Bind bind;
    bool differ = false;
    for (const aiBone* bone : std::span(mesh.mBones, mesh.mNumBones)) {
        const Matrix4d offset = toEigen(bone->mOffsetMatrix), place = offset.inverse();
        if (!offset.allFinite() || !place.allFinite() || !(std::abs(offset.determinant()) > 0.0)) return {};
        bind[table.boneNodes.at(bone)] = place;
        differ = differ || !place.isApprox(bind.begin()->second);
    }
    return differ ? bind : Bind{};
}

class BindPose {
public:
    BindPose(const NodeTable& table, Bind bind, uint32_t mesh) : table_(table), bind_(std::move(bind)), mesh_(mesh)
    {
        for (const auto& [node, place] : bind_) box_.extend(placeOf(table.globals[node]));
    }

    /// Whether the bind pose turns bones against each other differently from the nodes, and is otherwise alike.
    bool isOther() const
    {
        size_t turned = 0;
        for (const auto& [node, place] : bind_) {
            const Matrix4d& global = table_.globals[node];
            const int32_t parent = above(node);
            if (parent < 0) continue;
            const Matrix4d own = table_.globals[parent].inverse() * global,
                           bound = bind_.at(static_cast<uint32_t>(parent)).inverse() * place;
            const Vector3d scale = own.topLeftCorner<3, 3>().colwise().norm(),
                           boundScale = bound.topLeftCorner<3, 3>().colwise().norm();
            if ((scale - boundScale).cwiseAbs().maxCoeff() > SAME_SCALE * scale.maxCoeff()) return false;
            turned += angleBetween(turnOf(own), turnOf(bound)) > TURNED;
        }
        return bind_.size() >= FEWEST && turned >= FEWEST_TURNED;
    }

    /// From the mesh's space to the model's: that of the scene, of the mesh's node or of the skeleton's parent node if
    /// it puts bones about where their nodes are, else the one that keeps the first bone in place.
    Matrix4d placement() const
    {
        const uint32_t root = bind_.begin()->first;
        const int32_t holder = table_.parents[root];
        const Matrix4d atRoot = table_.globals[root] * bind_.begin()->second.inverse();
        Matrix4d best = atRoot;
        double least = misfit(atRoot) - BETTER;
        for (const Matrix4d& place :
             {holder < 0 ? table_.upright : table_.globals[holder], table_.globals[mesh_], table_.upright}) {
            const double off = misfit(place) - 2 * BETTER;
            if (off >= least) continue;
            least = off;
            best = place;
        }
        return best;
    }

    const Bind& bind() const { return bind_; }

private:
    int32_t above(uint32_t node) const
    {
        int32_t parent = table_.parents[node];
        while (parent >= 0 && !bind_.contains(static_cast<uint32_t>(parent))) parent = table_.parents[parent];
        return parent;
    }

    /// The mean distance of bones from their nodes, over the figure's size.
    double misfit(const Matrix4d& place) const
    {
        double sum = 0.0;
        for (const auto& [node, bound] : bind_) sum += (placeOf(place * bound) - placeOf(table_.globals[node])).norm();
        return sum / static_cast<double>(bind_.size()) / box_.sizes().norm();
    }

    const NodeTable& table_;
    Bind bind_;
    uint32_t mesh_;
    Eigen::AlignedBox3d box_;
};

}  // namespace

void takeBindPose(const aiScene& scene, NodeTable& table, std::vector<std::string>& notes)
{
    std::vector<BindPose> poses;
    forEachMesh(scene, table, [&](const aiMesh& mesh, uint32_t node) {
        Bind bind = bindOf(mesh, table);
        if (!bind.empty()) poses.emplace_back(table, std::move(bind), node);
    });
    if (std::ranges::none_of(poses, &BindPose::isOther)) return;
    std::map<uint32_t, Matrix4d> places;
    for (const BindPose& pose : poses) {
        const Matrix4d place = pose.placement();
        for (const auto& [bone, bound] : pose.bind()) places.try_emplace(bone, place * bound);
    }
    for (uint32_t n = 0; n < table.nodes.size(); ++n) {
        const auto bound = places.find(n);
        const int32_t parent = table.parents[n];
        if (bound != places.end()) table.globals[n] = bound->second;
        else if (parent >= 0) table.globals[n] = table.globals[parent] * table.locals[n];
    }
    notes.push_back(fmt::format("Nodes of {} bones stand in another pose than the one in which the mesh is bound to "
                                "them: that one is the rest pose.",
                                places.size()));
}

}  // namespace knuckle
