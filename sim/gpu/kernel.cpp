#include "sim/gpu/kernel.h"

#include <fmt/format.h>

#include <cctype>
#include <string_view>

#include "shared/gpu_types.h"
#include "sim/world/errors.h"

namespace knuckle {

namespace {

constexpr std::string_view LAST = "last";

using Scalar = ElementType::Scalar;

std::string resourceName(GLuint program, GLenum interface, GLuint index)
{
    char name[128] = "";
    glGetProgramResourceName(program, interface, index, sizeof name, nullptr, name);
    name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
    return name;
}

GLuint resourceCount(GLuint program, GLenum interface)
{
    GLint count = 0;
    glGetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
    return static_cast<GLuint>(count);
}

GLenum texelFormat(uint32_t bytes, bool isUnsigned)
{
    switch (bytes) {
        case 4: return isUnsigned ? GL_R32UI : GL_R32F;
        case 8: return isUnsigned ? GL_RG32UI : GL_RG32F;
        default: return isUnsigned ? GL_RGBA32UI : GL_RGBA32F;
    }
}

/// One property of an active resource.
GLint property(GLuint program, GLenum interface, GLuint index, GLenum asked)
{
    GLint value = 0;
    glGetProgramResourceiv(program, interface, index, 1, &asked, 1, nullptr, &value);
    return value;
}

/// A storage block is one array; it must consist of what the host says.
void checkBlock(GLuint program, GLuint block, const std::string& name, const ElementType& element,
                const std::string& kernel)
{
    const GLint count = property(program, GL_SHADER_STORAGE_BLOCK, block, GL_NUM_ACTIVE_VARIABLES);
    if (count < 1) return;
    // Room for all: Mesa 22.3 writes them all, whatever the buffer's size.
    std::vector<GLint> variables(static_cast<size_t>(count));
    const GLenum asked = GL_ACTIVE_VARIABLES;
    glGetProgramResourceiv(program, GL_SHADER_STORAGE_BLOCK, block, 1, &asked, count, nullptr, variables.data());
    const auto variable = static_cast<GLuint>(variables[0]);
    // Zero but for arrays of structs.
    GLint stride = property(program, GL_BUFFER_VARIABLE, variable, GL_TOP_LEVEL_ARRAY_STRIDE);
    if (stride == 0) stride = property(program, GL_BUFFER_VARIABLE, variable, GL_ARRAY_STRIDE);
    const auto type = static_cast<GLenum>(property(program, GL_BUFFER_VARIABLE, variable, GL_TYPE));
    if (stride == static_cast<GLint>(element.bytes) && (element.glType == GL_NONE || type == element.glType)) return;
    throw DeviceError(fmt::format("kernel {} declares the block \"{}\" with elements of {} bytes and another type than "
                                  "the host's, of {} bytes", kernel, name, stride, element.bytes));
}

}  // namespace

const BufferTable::Entry& BufferTable::find(const std::string& name, const std::string& kernel) const
{
    auto found = entries_.find(name);
    if (found == entries_.end() && name.starts_with(LAST) && name.size() > LAST.size()) {
        std::string own = name.substr(LAST.size());
        own[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(own[0])));
        found = entries_.find(own);
    }
    if (found == entries_.end())
        throw DeviceError(fmt::format("kernel {} wants a buffer \"{}\" that the solver does not have", kernel, name));
    return found->second;
}

KernelTimer::~KernelTimer()
{
    for (const Span& span : spans_) {
        glDeleteQueries(1, &span.start);
        glDeleteQueries(1, &span.stop);
    }
}

void KernelTimer::enable(const Gpu& gpu)
{
    enabled_ = true;
    waits_ = gpu.device().software;
}

void KernelTimer::stamp(GLuint query) const
{
    glQueryCounter(query, GL_TIMESTAMP);
    if (waits_) glFinish();
}

void KernelTimer::begin(const std::string& name)
{
    if (!enabled_) return;
    size_t total = 0;
    while (total < totals_.size() && totals_[total].first != name) ++total;
    if (total == totals_.size()) totals_.push_back({name, {}});
    if (used_ == spans_.size()) {
        Span span;
        glGenQueries(1, &span.start);
        glGenQueries(1, &span.stop);
        spans_.push_back(span);
    }
    spans_[used_].total = total;
    stamp(spans_[used_].start);
}

void KernelTimer::end()
{
    if (enabled_) stamp(spans_[used_++].stop);
}

void KernelTimer::collect()
{
    for (size_t i = 0; i < used_; ++i) {
        GLuint64 start = 0, stop = 0;
        glGetQueryObjectui64v(spans_[i].start, GL_QUERY_RESULT, &start);
        glGetQueryObjectui64v(spans_[i].stop, GL_QUERY_RESULT, &stop);
        Total& total = totals_[spans_[i].total].second;
        total.milliseconds += 1e-6 * static_cast<double>(stop - start);
        ++total.count;
    }
    used_ = 0;
}

Kernel::Kernel(const Gpu& gpu, const BufferTable& buffers, const std::string& path, const Defines& defines,
               const std::string& variant)
    : program_(Program::compute(gpu, path, defines)), name_(program_.name() + variant)
{
    bindStorage(buffers);
    bindTextures(buffers);
    bindUniformBlocks(buffers);
    if (storage_.size() > 8)
        throw DeviceError(fmt::format("kernel {} uses {} storage buffers; OpenGL 4.3 promises 8", name(),
                                      storage_.size()));
}

void Kernel::bindStorage(const BufferTable& buffers)
{
    for (GLuint i = 0; i < resourceCount(program_.id(), GL_SHADER_STORAGE_BLOCK); ++i) {
        const std::string block = resourceName(program_.id(), GL_SHADER_STORAGE_BLOCK, i);
        const BufferTable::Entry& entry = buffers.find(block, name());
        checkBlock(program_.id(), i, block, entry.element, name());
        glShaderStorageBlockBinding(program_.id(), i, static_cast<GLuint>(storage_.size()));
        storage_.push_back(entry.buffer);
    }
}

void Kernel::bindTextures(const BufferTable& buffers)
{
    for (GLuint i = 0; i < resourceCount(program_.id(), GL_UNIFORM); ++i) {
        const auto type = static_cast<GLenum>(property(program_.id(), GL_UNIFORM, i, GL_TYPE));
        const bool isFloat = type == GL_SAMPLER_BUFFER;
        if (!isFloat && type != GL_UNSIGNED_INT_SAMPLER_BUFFER) continue;
        const std::string sampler = resourceName(program_.id(), GL_UNIFORM, i);
        const BufferTable::Entry& entry = buffers.find(sampler, name());
        if (isFloat != (entry.element.scalar == Scalar::Float))
            throw DeviceError(fmt::format("kernel {} declares \"{}\" as a {}, which the host's buffer does not hold",
                                          name(), sampler, isFloat ? "samplerBuffer" : "usamplerBuffer"));
        glProgramUniform1i(program_.id(), property(program_.id(), GL_UNIFORM, i, GL_LOCATION),
                           static_cast<GLint>(textures_.size()));
        textures_.push_back({entry.buffer, texelFormat(entry.element.texelBytes, !isFloat)});
    }
}

void Kernel::bindUniformBlocks(const BufferTable& buffers)
{
    for (GLuint i = 0; i < resourceCount(program_.id(), GL_UNIFORM_BLOCK); ++i) {
        glUniformBlockBinding(program_.id(), i, static_cast<GLuint>(uniforms_.size()));
        const std::string block = resourceName(program_.id(), GL_UNIFORM_BLOCK, i);
        uniforms_.push_back(buffers.find(block, name()).buffer);
    }
}

void Kernel::begin(KernelTimer& timer) const
{
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name().c_str());
    glUseProgram(program_.id());
    for (GLuint i = 0; i < storage_.size(); ++i) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, storage_[i]->id());
    for (GLuint i = 0; i < uniforms_.size(); ++i) glBindBufferBase(GL_UNIFORM_BUFFER, i, uniforms_[i]->id());
    for (GLuint i = 0; i < textures_.size(); ++i) {
        glActiveTexture(GL_TEXTURE0 + i);
        glBindTexture(GL_TEXTURE_BUFFER, textures_[i].buffer->texture(textures_[i].format));
    }
    timer.begin(name());
}

void Kernel::end(KernelTimer& timer)
{
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    timer.end();
    glPopDebugGroup();
}

void Kernel::dispatch(KernelTimer& timer, uint32_t groups) const
{
    begin(timer);
    glDispatchCompute(groups, 1, 1);
    end(timer);
}

void Kernel::dispatchIndirect(KernelTimer& timer, const RawBuffer& arguments, uint32_t index) const
{
    begin(timer);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, arguments.id());
    glDispatchComputeIndirect(static_cast<GLintptr>(index * 16u));
    end(timer);
}

uint32_t groupsFor(uint64_t threads)
{
    return static_cast<uint32_t>((threads + GROUP_SIZE - 1) / GROUP_SIZE);
}

}  // namespace knuckle
