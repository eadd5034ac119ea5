#include "sim/actor/bodies/bone_bodies.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "sim/actor/bodies/body_tree.h"
#include "sim/world/cells.h"

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr size_t SPACE_POINTS = 4;    // the fewest particles that can span space
constexpr double ISLAND_PART = 0.25;  // a cut-off part below this share of its body changes sides

using Particles = std::vector<uint32_t>;

std::vector<uint32_t> assignBones(const Model& model, const Voxels& voxels)
{
    std::vector<uint32_t> bones;
    std::vector<float> sums(model.bones.size());
    for (const SurfacePoint& point : voxels.nearest) {
        std::fill(sums.begin(), sums.end(), 0.0f);
        for (int corner = 0; corner < 3; ++corner) {
            const SkinWeights& skin = model.skin[model.triangles[point.triangle][corner]];
            for (size_t i = 0; i < skin.bones.size(); ++i) {
                sums[skin.bones[i]] += point.barycentric[corner] * skin.weights[i];
            }
        }
        bones.push_back(static_cast<uint32_t>(std::max_element(sums.begin(), sums.end()) - sums.begin()));
    }
    return bones;
}

// The voxels' lattice again: each particle in the middle of a cell of its own, whatever was rounded.
class VoxelCells {
public:
    explicit VoxelCells(const Voxels& voxels) : voxels_(voxels), cells_(voxels.diameter)
    {
        for (uint32_t p = 0; p < voxels.positions.size(); ++p) cells_.add(place(p), p);
    }
    // Calls visit(index) for the particle and those beside it.
    template <typename Visit>
    void forEachAround(uint32_t particle, Visit visit) const
    {
        cells_.forEachAround(place(particle), visit);
    }

private:
    Vector3f place(uint32_t particle) const
    {
        return voxels_.positions[particle] - voxels_.positions.front() + Vector3f::Constant(0.5f * voxels_.diameter);
    }
    const Voxels& voxels_;
    Cells cells_;
};

// Where the skin's weights cut a bone's particles into pieces, a small piece goes to another bone whose particles it
// touches.
void moveIslands(std::vector<uint32_t>& bones, const Voxels& voxels)
{
    const VoxelCells cells(voxels);
    std::vector<Particles> parts;
    std::vector<uint8_t> seen(bones.size(), 0);
    std::map<uint32_t, size_t> sizes;
    for (uint32_t seed = 0; seed < bones.size(); ++seed) {
        ++sizes[bones[seed]];
        if (seen[seed]) {
            continue;
        }
        seen[seed] = 1;
        Particles part{seed};
        for (size_t i = 0; i < part.size(); ++i) {
            cells.forEachAround(part[i], [&](uint32_t other) {
                if (!seen[other] && bones[other] == bones[seed]) {
                    seen[other] = 1;
                    part.push_back(other);
                }
            });
        }
        parts.push_back(std::move(part));
    }
    const std::vector<uint32_t> before = bones;
    for (const Particles& part : parts) {
        const uint32_t own = before[part.front()];
        if (static_cast<double>(part.size()) >= ISLAND_PART * static_cast<double>(sizes[own])) {
            continue;
        }
        std::map<uint32_t, size_t> touching;
        for (uint32_t particle : part) {
            cells.forEachAround(particle, [&](uint32_t other) { touching[before[other]] += before[other] != own; });
        }
        touching.erase(own);
        const auto most = std::max_element(touching.begin(), touching.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        for (uint32_t particle : part) {
            bones[particle] = most == touching.end() ? own : most->first;
        }
    }
}

std::vector<Vector3f> positionsOf(const Particles& particles, const Voxels& voxels)
{
    std::vector<Vector3f> positions;
    for (uint32_t particle : particles) {
        positions.push_back(voxels.positions[particle]);
    }
    return positions;
}

std::vector<uint8_t> deformingBones(const Model& model)
{
    std::vector<uint8_t> deforms(model.bones.size(), 0);
    for (const SkinWeights& skin : model.skin) {
        for (size_t i = 0; i < skin.bones.size(); ++i) {
            deforms[skin.bones[i]] |= skin.weights[i] > 0.0f;
        }
    }
    return deforms;
}

// Gives every bone its particles, then lets bones too small for a body join their parents, children first.
struct BoneCut {
    std::vector<Particles> particles;
    std::vector<std::vector<std::string>> merged;
};

BoneCut mergeSmall(const Model& model, const Voxels& voxels, const std::vector<uint32_t>& bones)
{
    BoneCut cut{std::vector<Particles>(model.bones.size()), std::vector<std::vector<std::string>>(model.bones.size())};
    const std::vector<uint8_t> deforms = deformingBones(model);
    for (uint32_t p = 0; p < bones.size(); ++p) {
        cut.particles[bones[p]].push_back(p);
    }
    const auto join = [&](size_t from, size_t to) {
        cut.particles[to].insert(cut.particles[to].end(), cut.particles[from].begin(), cut.particles[from].end());
        cut.merged[to].insert(cut.merged[to].end(), cut.merged[from].begin(), cut.merged[from].end());
        if (deforms[from]) {
            cut.merged[to].push_back(model.bones[from].name);
        }
        cut.particles[from].clear();
        cut.merged[from].clear();
    };
    const auto large = [&](size_t b) { return spansSpace(positionsOf(cut.particles[b], voxels), voxels.diameter); };
    for (size_t b = model.bones.size(); b-- > 0;) {
        int32_t ancestor = model.bones[b].parent;
        while (ancestor >= 0 && cut.particles[ancestor].empty()) {
            ancestor = model.bones[ancestor].parent;
        }
        if (ancestor >= 0 && !large(b)) {
            join(b, static_cast<size_t>(ancestor));
        }
    }
    // No ancestor has a body: take the nearest body that is large enough.
    for (size_t b = 0; b < model.bones.size(); ++b) {
        if (cut.particles[b].empty() || large(b)) {
            continue;
        }
        float nearest = std::numeric_limits<float>::infinity();
        size_t target = b;
        for (size_t other = 0; other < model.bones.size(); ++other) {
            if (other != b && large(other)) {
                const float distance = contactOf(cut.particles[b], cut.particles[other], voxels).distance;
                target = distance < nearest ? other : target;
                nearest = std::min(nearest, distance);
            }
        }
        if (target != b) {
            join(b, target);
        }
    }
    return cut;
}

std::vector<BodyDraft> draftBodies(const Model& model, BoneCut& cut)
{
    std::vector<BodyDraft> drafts;
    std::vector<int32_t> draftOf(model.bones.size(), -1);
    for (uint32_t b = 0; b < model.bones.size(); ++b) {
        if (cut.particles[b].empty()) {
            continue;
        }
        draftOf[b] = static_cast<int32_t>(drafts.size());
        int32_t ancestor = model.bones[b].parent;
        while (ancestor >= 0 && draftOf[ancestor] < 0) {
            ancestor = model.bones[ancestor].parent;
        }
        std::sort(cut.particles[b].begin(), cut.particles[b].end());
        drafts.push_back({model.bones[b].name, b, ancestor < 0 ? -1 : draftOf[ancestor], std::move(cut.particles[b]),
                          std::move(cut.merged[b]), boneHead(model, b)});
    }
    return drafts;
}

}  // namespace

Vector3f boneHead(const Model& model, uint32_t bone)
{
    return model.bones[bone].restPose.block<3, 1>(0, 3);
}

bool spansSpace(const std::vector<Vector3f>& points, float diameter)
{
    if (points.size() < SPACE_POINTS) {
        return false;
    }
    Vector3f mean = Vector3f::Zero();
    for (const Vector3f& p : points) {
        mean += p / static_cast<float>(points.size());
    }
    Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero();
    for (const Vector3f& p : points) {
        covariance += (p - mean) * (p - mean).transpose() / static_cast<float>(points.size());
    }
    const float thinnest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f>(covariance).eigenvalues()[0];
    return thinnest > 0.01f * diameter * diameter;
}

std::vector<BodyDraft> cutIntoBodies(const Model& model, const Voxels& voxels, std::vector<std::string>& notes)
{
    if (model.bones.empty() || model.skin.size() != model.vertices.size()) {
        BodyDraft whole;
        whole.name = model.name;
        whole.particles.resize(voxels.positions.size());
        std::iota(whole.particles.begin(), whole.particles.end(), 0u);
        return {whole};
    }
    std::vector<uint32_t> bones = assignBones(model, voxels);
    moveIslands(bones, voxels);
    BoneCut cut = mergeSmall(model, voxels, bones);
    std::vector<BodyDraft> drafts = draftBodies(model, cut);
    arrangeTree(drafts, voxels, notes);
    for (const BodyDraft& draft : drafts) {
        if (!draft.mergedBones.empty()) {
            notes.push_back(fmt::format("{} took in {}, too small for four particles that span space.", draft.name,
                                        fmt::join(draft.mergedBones, ", ")));
        }
    }
    return drafts;
}

}  // namespace knuckle
