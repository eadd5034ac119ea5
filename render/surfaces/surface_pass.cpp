#include "render/surfaces/surface_pass.h"

#include <algorithm>
#include <span>
#include <vector>

#include "render/quantities/color_scale.h"
#include "render/spheres/palette.h"
#include "shared/frame_types.h"

namespace knuckle {

namespace {

/// Draws by their arguments.
enum Draw : uint32_t { FRONT, BACK, CLOTH_SHADOW, SOFT_SHADOW };

uint32_t groupsOf(size_t threads)
{
    return static_cast<uint32_t>((threads + RENDER_GROUP_SIZE - 1) / RENDER_GROUP_SIZE);
}

template <typename T>
void fill(Buffer<T>& buffer, const char* name, const std::vector<T>& data)
{
    buffer = {name, std::span<const T>(data)};
}

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
    const std::initializer_list<std::string> reads = {
        "frame",          "view",       "surfacePlaces",    "surfaceNormals",
        "surfaceLooks",   "velocities", "surfaceParticles", "hemEdges",
        "shownQuantities"};
    surfaces_ = DrawPass(gpu, table, {"surfaces/surface", "surfaces/surface", defines}, reads, targets.geometry);
    hems_ = DrawPass(gpu, table, {"surfaces/hem", "surfaces/surface", defines}, reads, targets.geometry);
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
    fill(indices_, "surfaceIndices", indices);
    fill(fanStarts_, "surfaceFanStarts", around.starts);
    fill(fans_, "surfaceFans", around.triangles);
    fill(particles_, "surfaceParticles", arrays.particles);
    fill(looks_, "surfaceLooks", arrays.looks);
    fill(sheets_, "clothSheets", arrays.sheets);
    fill(clothVertices_, "clothVertices", arrays.clothVertices);
    fill(nodes_, "clothNodes", arrays.clothNodes);
    fill(clothCells_, "clothCells", arrays.clothCells);
    fill(clothTriangles_, "clothTriangles", cloth);
    fill(hemEdges_, "hemEdges", arrays.hemEdges);
    fill(softVertices_, "softVertices", arrays.softVertices);
    fill(softLinks_, "softLinks", arrays.softLinks);
    fill(draws_, "surfaceDraws", draws);
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
        clothCellsKernel_.dispatch(timer, groupsOf(cellCount_));
        clothTrianglesKernel_.dispatch(timer, groupsOf(clothTriangleCount_));
        glMemoryBarrier(GL_ELEMENT_ARRAY_BARRIER_BIT);
    }
    if (clothVertexCount_ > 0) clothPlacesKernel_.dispatch(timer, groupsOf(clothVertexCount_));
    if (softVertexCount_ > 0) {
        glProgramUniform1ui(softPlacesKernel_.program(), 0, clothVertexCount_);
        softPlacesKernel_.dispatch(timer, groupsOf(softVertexCount_));
    }
    normalsKernel_.dispatch(timer, groupsOf(looks_.size()));
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
