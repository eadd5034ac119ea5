#include "sim/world/builder/parts/cloth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

/// Rows of a grid of nodes, as strands.
class GridStrands {
public:
    GridStrands(ClothSheet& sheet, const ClothSpec& spec)
        : sheet_(sheet), spec_(spec), columns_(static_cast<int>(sheet.columns)), rows_(static_cast<int>(sheet.rows))
    {
    }

    void add()
    {
        for (int j = 0; j < rows_; ++j) add(DistanceKind::Stretch, 0, j, 1, 0);
        for (int k = 0; k < columns_; ++k) add(DistanceKind::Stretch, k, 0, 0, 1);
        for (int k = 1 - rows_; k < columns_; ++k) add(DistanceKind::Shear, std::max(k, 0), std::max(-k, 0), 1, 1);
        for (int k = 0; k < columns_ + rows_ - 1; ++k)
            add(DistanceKind::Shear, std::min(k, columns_ - 1), std::max(0, k - columns_ + 1), -1, 1);
        if (!std::isfinite(spec_.bendCompliance)) return;
        for (int j = 0; j < rows_; ++j)
            for (int k = 0; k < 2; ++k) add(DistanceKind::Bend, k, j, 2, 0);
        for (int k = 0; k < columns_; ++k)
            for (int j = 0; j < 2; ++j) add(DistanceKind::Bend, k, j, 0, 2);
    }

private:
    bool inside(int k, int j) const { return k >= 0 && k < columns_ && j >= 0 && j < rows_; }

    /// Adds a row from node (k, j) in steps of (stepK, stepJ) to the edge.
    void add(DistanceKind kind, int k, int j, int stepK, int stepJ)
    {
        Strand row;
        row.kind = kind;
        row.tearForce = spec_.tearForce;
        row.compliance = kind == DistanceKind::Stretch ? spec_.stretchCompliance
                         : kind == DistanceKind::Shear ? spec_.shearCompliance
                                                       : spec_.bendCompliance;
        for (; inside(k, j); k += stepK, j += stepJ) {
            row.particles.push_back(static_cast<uint32_t>(j * columns_ + k));
            if (row.particles.size() < 2) continue;
            const size_t last = row.particles.size() - 1;
            row.restLengths.push_back(
                (sheet_.nodes[row.particles[last]] - sheet_.nodes[row.particles[last - 1]]).norm());
        }
        if (row.particles.size() > 1) sheet_.strands.push_back(std::move(row));
    }

    ClothSheet& sheet_;
    const ClothSpec& spec_;
    int columns_, rows_;
};

uint32_t cellsOf(float length, float diameter)
{
    return static_cast<uint32_t>(std::max(1.0f, std::ceil(length / diameter - 1e-3f)));
}

void addTie(WorldBuilder& builder, const ClothSpec& spec, uint32_t node, uint32_t particle)
{
    const auto& particles = builder.world().particles;
    const float distance = (particles[node].position - particles[particle].position).norm();
    if (distance > 1.001f * builder.diameter())
        throw InputError(fmt::format("the cloth is {} m from the particle that it is attached to, and may be {} m, a "
                                     "diameter; bring them nearer",
                                     distance, builder.diameter()));
    Strand tie;
    tie.tearForce = spec.tearForce;
    tie.particles = {node, particle};
    tie.restLengths = {std::max(distance, 0.01f * builder.diameter())};
    builder.addStrand(tie);
}

}  // namespace

ClothSheet gridSheet(float width, float depth, float diameter, const ClothSpec& spec)
{
    const uint32_t across = cellsOf(width, diameter), along = cellsOf(depth, diameter);
    const float stepX = width / static_cast<float>(across), stepZ = depth / static_cast<float>(along);
    ClothSheet sheet;
    sheet.columns = across + 1;
    sheet.rows = along + 1;
    for (uint32_t j = 0; j <= along; ++j)
        for (uint32_t k = 0; k <= across; ++k) {
            sheet.nodes.emplace_back(static_cast<float>(k) * stepX - 0.5f * width, 0.0f,
                                     static_cast<float>(j) * stepZ - 0.5f * depth);
            const float shareX = k == 0 || k == across ? 0.5f : 1.0f, shareZ = j == 0 || j == along ? 0.5f : 1.0f;
            sheet.areas.push_back(stepX * shareX * stepZ * shareZ);
        }
    for (uint32_t j = 0; j < along; ++j)
        for (uint32_t k = 0; k < across; ++k) {
            const uint32_t node = j * sheet.columns + k, below = node + sheet.columns;
            sheet.triangles.push_back({node, below, node + 1});
            sheet.triangles.push_back({node + 1, below, below + 1});
        }
    GridStrands(sheet, spec).add();
    return sheet;
}

uint32_t addCloth(WorldBuilder& builder, const std::string& name, const ClothSheet& sheet, const ClothSpec& spec,
                  std::span<const uint32_t> held, std::span<const ClothTie> ties, const Pose& pose,
                  const Vector3f& velocity)
{
    builder.beginObject(name);
    std::vector<uint32_t> particles(sheet.nodes.size(), NO_INDEX);
    std::vector<Vector3f> heldPlaces;
    for (uint32_t node : held) {
        if (particles.at(node) != NO_INDEX) continue;
        particles[node] = builder.particleCount() + static_cast<uint32_t>(heldPlaces.size());
        heldPlaces.push_back(sheet.nodes[node]);
    }
    if (!heldPlaces.empty()) builder.addBody("held", heldPlaces, spec.material, Motion::Fixed);
    for (uint32_t node = 0; node < sheet.nodes.size(); ++node) {
        if (particles[node] != NO_INDEX) continue;
        Particle particle;
        particle.position = particle.restPosition = sheet.nodes[node];
        particle.selfMargin = ROPE_MARGIN;
        particle.material = spec.material;
        particle.mass = builder.world().materials.at(spec.material).density * builder.diameter() * sheet.areas[node];
        particles[node] = builder.addLooseParticle(particle);
    }
    const uint32_t object = builder.endObject(pose, velocity);
    for (Strand row : sheet.strands) {
        for (uint32_t& particle : row.particles) particle = particles[particle];
        builder.addStrand(std::move(row));
    }
    for (const auto& [a, b, c] : sheet.triangles) builder.addClothTriangle({particles[a], particles[b], particles[c]});
    if (spec.drawn) builder.drawCloth({particles, sheet.triangles, sheet.columns, sheet.rows});
    for (const ClothTie& tie : ties) addTie(builder, spec, particles.at(tie.node), tie.particle);
    return object;
}

}  // namespace knuckle
