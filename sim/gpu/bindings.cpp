#include "sim/gpu/bindings.h"

#include <fmt/format.h>

#include <bit>
#include <cctype>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

using Scalar = ElementType::Scalar;

GLuint resourceCount(GLuint program, GLenum interface)
{
    GLint count = 0;
    glGetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
    return static_cast<GLuint>(count);
}

/// One property of an active resource.
GLint property(GLuint program, GLenum interface, GLuint index, GLenum asked)
{
    GLint value = 0;
    glGetProgramResourceiv(program, interface, index, 1, &asked, 1, nullptr, &value);
    return value;
}

std::string lowercaseFirst(std::string name)
{
    if (!name.empty()) name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
    return name;
}

/// "slotPressures" for "newSlotPressures": a shader may have a sampler of the same buffer.
std::string withoutNew(const std::string& name)
{
    const std::string prefix = "new";
    const bool isNew = name.starts_with(prefix) && name.size() > prefix.size() &&
                       std::isupper(static_cast<unsigned char>(name[prefix.size()])) != 0;
    return isNew ? lowercaseFirst(name.substr(prefix.size())) : name;
}

/// Whether a member of a kernel's struct fits the host's elements of that scalar.
bool fits(GLenum member, Scalar scalar)
{
    const bool isUnsigned = member == GL_UNSIGNED_INT || member == GL_UNSIGNED_INT_VEC2 ||
                            member == GL_UNSIGNED_INT_VEC4;
    return scalar == Scalar::Mixed || isUnsigned == (scalar == Scalar::Unsigned);
}

/// Checks a storage block: it is one array, or one struct, and must match the host's type. Where the host has vectors,
/// a kernel may name their components by a struct of the same size.
void checkBlock(GLuint program, GLuint block, const std::string& name, const ElementType& element,
                const std::string& user)
{
    const GLint count = property(program, GL_SHADER_STORAGE_BLOCK, block, GL_NUM_ACTIVE_VARIABLES);
    if (count < 1) return;
    // Room for all of them: Mesa writes all, regardless of the given size.
    std::vector<GLint> variables(static_cast<size_t>(count));
    const GLenum asked = GL_ACTIVE_VARIABLES;
    glGetProgramResourceiv(program, GL_SHADER_STORAGE_BLOCK, block, 1, &asked, count, nullptr, variables.data());
    const auto variable = static_cast<GLuint>(variables[0]);
    const auto type = static_cast<GLenum>(property(program, GL_BUFFER_VARIABLE, variable, GL_TYPE));
    // The first is of arrays of structs, the second of other arrays; a struct by itself has neither.
    GLint bytes = property(program, GL_BUFFER_VARIABLE, variable, GL_TOP_LEVEL_ARRAY_STRIDE);
    const bool isStruct = bytes != 0 || element.glType == GL_NONE;
    if (bytes == 0) bytes = property(program, GL_BUFFER_VARIABLE, variable, GL_ARRAY_STRIDE);
    if (bytes == 0) bytes = property(program, GL_SHADER_STORAGE_BLOCK, block, GL_BUFFER_DATA_SIZE);
    const bool sameType = isStruct ? fits(type, element.scalar) : type == element.glType;
    if (bytes == static_cast<GLint>(element.bytes) && sameType) return;
    throw DeviceError(fmt::format("{} declares the block \"{}\" with elements of {} bytes{}; the host's have {}", user,
                                  name, bytes, sameType ? "" : " and of another type", element.bytes));
}

/// A small size for which llvmpipe compiles the same code. It asks whether a texture's size is a power of two, and
/// whether levels of a picture are 0, for which it takes the second byte of a buffer's size, of an image's the lowest.
size_t sizeLike(size_t bytes)
{
    const size_t levels = ((bytes & 0xffu) != 0 ? 0x10u : 0u) + ((bytes & 0xff00u) != 0 ? 0x100u : 0u);
    const size_t size = levels != 0 ? levels : 0x10000u;
    return std::has_single_bit(size) && !std::has_single_bit(bytes) ? 3 * size : size;
}

}  // namespace

Bindings::Bindings(const Program& program, const BufferTable& table, const std::string& user, Renames renames)
    : program_(program.id()), renames_(std::move(renames))
{
    findStorage(table, user);
    findUniforms(table, user);
    findSamplers(table, user);
    findImages(table, user);
}

/// Names of blocks begin with a capital in shaders; names in the table do not.
std::string Bindings::resourceName(GLenum interface, GLuint index) const
{
    char declared[128] = "";
    glGetProgramResourceName(program_, interface, index, sizeof declared, nullptr, declared);
    std::string name = lowercaseFirst(declared);
    for (const auto& [from, to] : renames_) {
        const bool isWord = name.size() == from.size() ||
                            (name.size() > from.size() &&
                             std::isupper(static_cast<unsigned char>(name[from.size()])) != 0);
        if (isWord && name.starts_with(from)) return to + name.substr(from.size());
    }
    return name;
}

void Bindings::findStorage(const BufferTable& table, const std::string& user)
{
    for (GLuint i = 0; i < resourceCount(program_, GL_SHADER_STORAGE_BLOCK); ++i) {
        const std::string block = resourceName(GL_SHADER_STORAGE_BLOCK, i);
        const BufferTable::Entry& entry = table.find(block, user);
        checkBlock(program_, i, block, entry.element, user);
        glShaderStorageBlockBinding(program_, i, static_cast<GLuint>(storage_.size()));
        storage_.push_back(entry.buffer);
    }
}

void Bindings::findUniforms(const BufferTable& table, const std::string& user)
{
    for (GLuint i = 0; i < resourceCount(program_, GL_UNIFORM_BLOCK); ++i) {
        glUniformBlockBinding(program_, i, static_cast<GLuint>(uniforms_.size()));
        uniforms_.push_back(table.find(resourceName(GL_UNIFORM_BLOCK, i), user).buffer);
    }
}

void Bindings::findSamplers(const BufferTable& table, const std::string& user)
{
    for (GLuint i = 0; i < resourceCount(program_, GL_UNIFORM); ++i) {
        const auto type = static_cast<GLenum>(property(program_, GL_UNIFORM, i, GL_TYPE));
        const bool isPicture = type == GL_SAMPLER_2D || type == GL_UNSIGNED_INT_SAMPLER_2D;
        const bool isFloat = type == GL_SAMPLER_BUFFER;
        if (!isPicture && !isFloat && type != GL_UNSIGNED_INT_SAMPLER_BUFFER) continue;
        const std::string sampler = resourceName(GL_UNIFORM, i);
        glProgramUniform1i(program_, property(program_, GL_UNIFORM, i, GL_LOCATION),
                           static_cast<GLint>(samplers_.size()));
        if (isPicture) {
            samplers_.push_back({nullptr, GL_NONE, &table.findTexture(sampler, user)});
            continue;
        }
        const BufferTable::Entry& entry = table.find(sampler, user);
        if (isFloat != (entry.element.scalar == Scalar::Float))
            throw DeviceError(fmt::format("{} declares \"{}\" as a {}, which the host's buffer does not hold", user,
                                          sampler, isFloat ? "samplerBuffer" : "usamplerBuffer"));
        samplers_.push_back({entry.buffer, texelFormat(entry.element), nullptr, entry.element.texelBytes});
    }
}

void Bindings::findImages(const BufferTable& table, const std::string& user)
{
    for (GLuint i = 0; i < resourceCount(program_, GL_UNIFORM); ++i) {
        const auto type = static_cast<GLenum>(property(program_, GL_UNIFORM, i, GL_TYPE));
        const bool isFloat = type == GL_IMAGE_BUFFER;
        if (!isFloat && type != GL_UNSIGNED_INT_IMAGE_BUFFER) continue;
        const std::string image = withoutNew(resourceName(GL_UNIFORM, i));
        const BufferTable::Entry& entry = table.find(image, user);
        if (isFloat != (entry.element.scalar == Scalar::Float))
            throw DeviceError(fmt::format("{} declares \"{}\" as {} imageBuffer, which the host's buffer does not hold",
                                          user, image, isFloat ? "an" : "an unsigned"));
        glProgramUniform1i(program_, property(program_, GL_UNIFORM, i, GL_LOCATION),
                           static_cast<GLint>(images_.size()));
        images_.push_back({entry.buffer, texelFormat(entry.element), nullptr, entry.element.texelBytes});
    }
}

void Bindings::checkSizes(const Gpu& gpu, const std::string& user) const
{
    const auto check = [&](const RawBuffer& buffer, uint64_t limit) {
        if (buffer.bytes() > limit)
            throw DeviceError(
                fmt::format("{}: {} needs {} MiB for \"{}\" and the device allows {}; use fewer particles "
                            "or another --device",
                            gpu.device().name, user, buffer.bytes() >> 20, buffer.label(), limit >> 20));
    };
    for (const RawBuffer* buffer : storage_) check(*buffer, static_cast<uint64_t>(gpu.limits().storageBlockSize));
    for (const std::vector<Sampled>* list : {&samplers_, &images_})
        for (const Sampled& sampled : *list)
            if (sampled.buffer != nullptr)
                check(*sampled.buffer, static_cast<uint64_t>(gpu.limits().textureBufferSize) * sampled.texelBytes);
}

const RawBuffer& Placeholders::of(const RawBuffer& buffer, GLenum format)
{
    const size_t bytes = sizeLike(buffer.bytes());
    RawBuffer& made = made_[{format, bytes}];
    if (made.id() == 0) made = RawBuffer("placeholder", bytes);
    return made;
}

template <typename As>
void Bindings::bindAs(const As& as) const
{
    glUseProgram(program_);
    for (GLuint i = 0; i < storage_.size(); ++i)
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, as(*storage_[i], GL_NONE).id());
    for (GLuint i = 0; i < uniforms_.size(); ++i)
        glBindBufferBase(GL_UNIFORM_BUFFER, i, as(*uniforms_[i], GL_NONE).id());
    // Making a buffer's texture changes the active unit: so images come first, and each sampler selects its unit.
    for (GLuint i = 0; i < images_.size(); ++i)
        glBindImageTexture(i, as(*images_[i].buffer, images_[i].format).texture(images_[i].format), 0, GL_FALSE, 0,
                           GL_READ_WRITE, images_[i].format);
    for (GLuint i = 0; i < samplers_.size(); ++i) {
        const Sampled& sampled = samplers_[i];
        glActiveTexture(GL_TEXTURE0 + i);
        const GLuint texture = sampled.picture != nullptr ? sampled.picture->id()
                                                          : as(*sampled.buffer, sampled.format).texture(sampled.format);
        glBindTexture(sampled.picture != nullptr ? GL_TEXTURE_2D : GL_TEXTURE_BUFFER, texture);
    }
}

void Bindings::bind() const
{
    bindAs([](const RawBuffer& own, GLenum) -> const RawBuffer& { return own; });
}

void Bindings::bind(Placeholders& others) const
{
    bindAs([&](const RawBuffer& own, GLenum format) -> const RawBuffer& { return others.of(own, format); });
}

}  // namespace knuckle
