#include "render/spheres/sphere_pass.h"

#include <fmt/format.h>

#include "render/spheres/palette.h"
#include "sim/world/errors.h"

namespace knuckle {

namespace {

constexpr size_t CELL_COUNT = size_t{BURIAL_CELLS} * BURIAL_CELLS * BURIAL_CELLS;

/// Where one of the indirect draws has its arguments.
const void* argumentsOf(size_t draw)
{
    return reinterpret_cast<const void*>(draw * sizeof(gpu::DrawArguments));
}

Defines colorDefines(const RenderSettings& settings)
{
    if (settings.colorBy == ColorBy::Speed) return {{"COLOR_BY_SPEED", "1"}};
    return {};
}

size_t chunkCount(size_t particleCount)
{
    return (particleCount + LIST_CHUNK - 1) / LIST_CHUNK;
}

void bindBufferTexture(GLuint unit, GLuint texture)
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_BUFFER, texture);
}

void viewBuffer(GLuint& texture, GLuint buffer)
{
    if (texture == 0) glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_BUFFER, texture);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer);
}

}  // namespace

SpherePass::SpherePass(const Gpu& gpu, const World& world, const RenderSettings& settings)
    : burialCount_(Program::compute(gpu, "render/spheres/burial_count.comp")),
      burialCells_(Program::compute(gpu, "render/spheres/burial_cells.comp")),
      burialHidden_(Program::compute(gpu, "render/spheres/burial_hidden.comp")),
      cull_(Program::compute(gpu, "render/spheres/sphere_cull.comp")),
      offsets_(Program::compute(gpu, "render/spheres/sphere_offsets.comp")),
      list_(Program::compute(gpu, "render/spheres/sphere_list.comp")),
      points_(Program::graphics(gpu, "render/spheres/sphere.vert", "render/spheres/sphere.frag",
                                colorDefines(settings))),
      quads_(Program::graphics(gpu, "render/spheres/sphere_quad.vert", "render/spheres/sphere.frag",
                               colorDefines(settings))),
      shadow_(Program::graphics(gpu, "render/spheres/sphere_shadow.vert", "render/spheres/sphere_shadow.frag")),
      colors_("sphere colours", particleColors(world, settings)), visible_("sphere visible", world.particles.size()),
      counts_("sphere counts", 4 * chunkCount(world.particles.size())),
      indices_("sphere list", 3 * world.particles.size()),
      cells_("burial cells", CELL_COUNT), buried_("buried cells", CELL_COUNT), draws_("sphere draws", DRAW_COUNT)
{
    GLfloat range[2] = {1, 1};
    glGetFloatv(GL_POINT_SIZE_RANGE, range);
    pointSizeLimit_ = range[1];
    glGenVertexArrays(1, &pointArray_);
    glGenVertexArrays(1, &quadArray_);
}

SpherePass::~SpherePass()
{
    glDeleteTextures(1, &positionTexture_);
    glDeleteTextures(1, &velocityTexture_);
    glDeleteVertexArrays(1, &pointArray_);
    glDeleteVertexArrays(1, &quadArray_);
}

void SpherePass::attach(const ParticleView& view)
{
    if (view.particleCount != colors_.size())
        throw RunError(fmt::format("the renderer was made for {} particles, and the solver has {}", colors_.size(),
                                   view.particleCount));
    // Also when the name is the same: the solver may have grown the buffer and been given its old name again.
    viewBuffer(positionTexture_, view.positions);
    viewBuffer(velocityTexture_, view.velocities);
    attached_ = view;
    bindAttributes(view.positions);
    // Asked for first: making it disturbs the active unit.
    const GLuint colorTexture = colors_.texture(GL_R32UI);
    bindBufferTexture(POSITIONS_UNIT, positionTexture_);
    bindBufferTexture(VELOCITIES_UNIT, velocityTexture_);
    bindBufferTexture(COLORS_UNIT, colorTexture);
}

void SpherePass::bindAttributes(GLuint positions)
{
    glBindVertexArray(pointArray_);
    glBindBuffer(GL_ARRAY_BUFFER, positions);
    glEnableVertexAttribArray(POSITION_ATTRIBUTE);
    glVertexAttribPointer(POSITION_ATTRIBUTE, 3, GL_FLOAT, GL_FALSE, sizeof(gpu::vec4), nullptr);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());

    glBindVertexArray(quadArray_);
    glBindBuffer(GL_ARRAY_BUFFER, indices_.id());
    glEnableVertexAttribArray(INDEX_ATTRIBUTE);
    const size_t firstQuad = attached_.particleCount * sizeof(uint32_t);
    glVertexAttribIPointer(INDEX_ATTRIBUTE, 1, GL_UNSIGNED_INT, sizeof(uint32_t),
                           reinterpret_cast<const void*>(firstQuad));
    glVertexAttribDivisor(INDEX_ATTRIBUTE, 1);
}

void SpherePass::drawShadow() const
{
    if (attached_.particleCount == 0) return;
    glUseProgram(shadow_.id());
    glBindVertexArray(pointArray_);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, draws_.id());
    glDrawElementsIndirect(GL_POINTS, GL_UNSIGNED_INT, argumentsOf(SHADOW_DRAW));
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

void SpherePass::findBuried()
{
    cells_.clear();
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, RENDER_CELLS_SLOT, cells_.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, RENDER_BURIED_SLOT, buried_.id());
    glUseProgram(burialCount_.id());
    glDispatchCompute((attached_.particleCount + RENDER_GROUP_SIZE - 1) / RENDER_GROUP_SIZE, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    glUseProgram(burialCells_.id());
    glDispatchCompute(CELL_COUNT / RENDER_GROUP_SIZE, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    glUseProgram(burialHidden_.id());
    glDispatchCompute(CELL_COUNT / RENDER_GROUP_SIZE, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void SpherePass::list()
{
    if (attached_.particleCount == 0) return;
    findBuried();
    const auto chunks = static_cast<GLuint>(chunkCount(attached_.particleCount));
    const GLuint groups = (chunks + RENDER_GROUP_SIZE - 1) / RENDER_GROUP_SIZE;
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, RENDER_VISIBLE_SLOT, visible_.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, RENDER_COUNTS_SLOT, counts_.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, RENDER_LIST_SLOT, indices_.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, RENDER_DRAWS_SLOT, draws_.id());
    glUseProgram(cull_.id());
    glDispatchCompute(groups, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    glUseProgram(offsets_.id());
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    glUseProgram(list_.id());
    glDispatchCompute(groups, 1, 1);
    glMemoryBarrier(GL_ELEMENT_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
}

void SpherePass::draw() const
{
    if (attached_.particleCount == 0) return;
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, draws_.id());
    glUseProgram(points_.id());
    glBindVertexArray(pointArray_);
    glDrawElementsIndirect(GL_POINTS, GL_UNSIGNED_INT, argumentsOf(POINT_DRAW));
    glUseProgram(quads_.id());
    glBindVertexArray(quadArray_);
    glDrawArraysIndirect(GL_TRIANGLE_STRIP, argumentsOf(QUAD_DRAW));
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

}  // namespace knuckle
