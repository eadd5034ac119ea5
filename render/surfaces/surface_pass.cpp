#include "render/surfaces/surface_pass.h"

#include <algorithm>
#include <vector>

#include "render/looks/picture_defines.h"
#include "render/quantities/color_scale.h"
#include "render/render_groups.h"
#include "render/spheres/palette.h"
#include "shared/frame_types.h"
#include "sim/gpu/filled_buffer.h"

namespace knuckle {

namespace {

/// Draws by their arguments.
enum Draw : uint32_t { FRONT, BACK, CLOTH_SHADOW, SOFT_SHADOW };

bool mayTear(const gpu::uvec4& cell)
{
    return cell.x != NEVER_TORN || cell.y != NEVER_TORN || cell.z != NEVER_TORN || cell.w != NEVER_TORN;
}

}  // namespace

SurfacePass::SurfacePass(const Gpu& gpu, BufferTable& table, const World& world, const RenderSettings& settings,
                         const RenderTargets& targets)
{
    if (world.drawn.cloth.empty() && world.drawn.soft.empty()) return;
    const SurfaceArrays arrays(world, particleColors(world, settings));
    upload(table, arrays);
    const Defines tearing = tears_ ? Defines{{"TEARS", "1"}} : Defines{};
    const auto load = [&](const std::string& name, const Defines& defines = {}) {
        return Kernel(gpu, table, "render/surfaces/" + name + ".comp", defines);
    };
    if (tears_) {
        clothCellsKernel_ = load("cloth_cells");
        clothTrianglesKernel_ = load("cloth_triangles");
    }
    if (clothVertexCount_ > 0) clothPlacesKernel_ = load("cloth_places", tearing);
    if (softVertexCount_ > 0) softPlacesKernel_ = load("soft_places");
    normalsKernel_ = load("surface_normals");
    Defines defines = colorDefines(world, settings);
    std::vector<std::string> reads = {"surfacePlaces",    "surfaceNormals", "surfaceLooks",   "velocities",
                                      "surfaceParticles", "hemEdges",       "shownQuantities"};
    if (targets.hasLayers()) {
        earlier_.add(table, places_);
        earlier_.add(table, normals_);
        reads.insert(reads.end(), {"earlierSurfacePlaces", "earlierSurfaceNormals"});
    }
    const Defines seen = joined({defines, targets.layerDefines(true)});
    surfaces_ = DrawPass(gpu, table, {"surfaces/surface", "surfaces/surface", seen}, reads, targets.geometry);
    hems_ = DrawPass(gpu, table, {"surfaces/hem", "surfaces/surface", seen}, reads, targets.geometry);
    defines.push_back({"LIGHT_VIEW", "1"});
    shadow_ = DrawPass(gpu, table, {"surfaces/surface", "surfaces/surface_shadow", defines}, reads, targets.shadowMap);
}

void SurfacePass::upload(BufferTable& table, const SurfaceArrays& arrays)
{
    clothVertexCount_ = static_cast<uint32_t>(arrays.clothVertices.size());
    softVertexCount_ = static_cast<uint32_t>(arrays.softVertices.size());
    clothTriangleCount_ = static_cast<uint32_t>(arrays.cells.size());
    cellCount_ = static_cast<uint32_t>(arrays.clothCells.size());
    tears_ = std::ranges::any_of(arrays.clothCells, mayTear);
    const auto count = static_cast<uint32_t>(arrays.looks.size());
    const TriangleFans around = makeFans(count, arrays.triangles);
    std::vector<uint32_t> indices;
    std::vector<gpu::uvec4> cloth;
    for (const Triangle& triangle : arrays.triangles) indices.insert(indices.end(), triangle.begin(), triangle.end());
    for (size_t t = 0; t < arrays.cells.size(); ++t) {
        const auto& [a, b, c] = arrays.triangles[t];
        cloth.push_back({a, b, c, arrays.cells[t]});
    }
    const uint32_t ofCloth = 3 * clothTriangleCount_, all = static_cast<uint32_t>(indices.size());
    const std::vector<gpu::DrawElementsArguments> draws{
        {all, 1, 0, 0, 0}, {ofCloth, 1, 0, count, 0}, {ofCloth, 1, 0, 2 * count, 0}, {all - ofCloth, 1, ofCloth, 0, 0}};
    indices_ = filledBuffer("surfaceIndices", indices);
    fanStarts_ = filledBuffer("surfaceFanStarts", around.starts);
    fans_ = filledBuffer("surfaceFans", around.triangles);
    particles_ = filledBuffer("surfaceParticles", arrays.particles);
    looks_ = filledBuffer("surfaceLooks", arrays.looks);
    sheets_ = filledBuffer("clothSheets", arrays.sheets);
    clothVertices_ = filledBuffer("clothVertices", arrays.clothVertices);
    nodes_ = filledBuffer("clothNodes", arrays.clothNodes);
    clothCells_ = filledBuffer("clothCells", arrays.clothCells);
    clothTriangles_ = filledBuffer("clothTriangles", cloth);
    hemEdges_ = filledBuffer("hemEdges", arrays.hemEdges);
    softVertices_ = filledBuffer("softVertices", arrays.softVertices);
    softLinks_ = filledBuffer("softLinks", arrays.softLinks);
    draws_ = filledBuffer("surfaceDraws", draws);
    places_ = {"surfacePlaces", count};
    normals_ = {"surfaceNormals", count};
    torn_ = {"clothTorn", cellCount_};
    table.add(Lifetime::Constant, fanStarts_, fans_, particles_, looks_, sheets_, clothVertices_, nodes_, clothCells_,
              clothTriangles_, hemEdges_, softVertices_, softLinks_);
    table.add(Lifetime::Scratch, indices_, places_, normals_, torn_);
}

void SurfacePass::update(KernelTimer& timer)
{
    if (indices_.size() == 0) return;
    if (tears_) {
        clothCellsKernel_.dispatch(timer, renderGroups(cellCount_));
        clothTrianglesKernel_.dispatch(timer, renderGroups(clothTriangleCount_));
        glMemoryBarrier(GL_ELEMENT_ARRAY_BARRIER_BIT);
    }
    if (clothVertexCount_ > 0) clothPlacesKernel_.dispatch(timer, renderGroups(clothVertexCount_));
    if (softVertexCount_ > 0) {
        glProgramUniform1ui(softPlacesKernel_.program(), 0, clothVertexCount_);
        softPlacesKernel_.dispatch(timer, renderGroups(softVertexCount_));
    }
    normalsKernel_.dispatch(timer, renderGroups(looks_.size()));
}

void SurfacePass::drawShadow(KernelTimer& timer) const
{
    if (indices_.size() == 0) return;
    shadow_.drawIndexed(timer, indices_, draws_, {CLOTH_SHADOW, 1});
    // Only faces turned away from the light cast shadows, so that lit faces do not shade themselves.
    shadow_.drawIndexed(timer, indices_, draws_, {SOFT_SHADOW, 1, GL_FRONT});
}

void SurfacePass::draw(KernelTimer& timer) const
{
    if (indices_.size() == 0) return;
    surfaces_.drawIndexed(timer, indices_, draws_, {FRONT, 1, GL_BACK});
    surfaces_.drawIndexed(timer, indices_, draws_, {BACK, 1, GL_FRONT});
    hems_.draw(timer, GL_TRIANGLE_STRIP, HEM_STRIP, static_cast<uint32_t>(hemEdges_.size()));
}

}  // namespace knuckle
