#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "shared/vector_types.h"
#include "sim/gpu/buffer.h"
#include "sim/gpu/texture.h"

namespace knuckle {

/// The host's type of a buffer's elements, which declarations of kernels are checked against.
struct ElementType {
    enum class Scalar { Float, Unsigned, Mixed };

    uint32_t bytes = 4;             ///< Of one element.
    uint32_t texelBytes = 4;        ///< Of one texel of the buffer's texture: 4, 8 or 16.
    Scalar scalar = Scalar::Mixed;  ///< Mixed: a struct of both, which kernels read as unsigned texels.
    GLenum glType = GL_NONE;        ///< GL_FLOAT_VEC4, GL_UNSIGNED_INT, ...; GL_NONE for structs.
};

/// The ElementType of T: float, uint32_t, the vectors of vector_types.h, or a struct, which counts as mixed.
template <typename T>
constexpr ElementType elementType()
{
    using Scalar = ElementType::Scalar;
    constexpr uint32_t bytes = sizeof(T), texel = bytes < 16 ? bytes : 16;
    if (std::is_same_v<T, float>) return {bytes, texel, Scalar::Float, GL_FLOAT};
    if (std::is_same_v<T, gpu::vec4>) return {bytes, texel, Scalar::Float, GL_FLOAT_VEC4};
    if (std::is_same_v<T, uint32_t>) return {bytes, texel, Scalar::Unsigned, GL_UNSIGNED_INT};
    if (std::is_same_v<T, gpu::uvec2>) return {bytes, texel, Scalar::Unsigned, GL_UNSIGNED_INT_VEC2};
    if (std::is_same_v<T, gpu::uvec4>) return {bytes, texel, Scalar::Unsigned, GL_UNSIGNED_INT_VEC4};
    return {bytes, texel, Scalar::Mixed, GL_NONE};
}

/// For a struct of floats only, which kernels read as floats.
template <typename T>
constexpr ElementType floatStructType()
{
    return {sizeof(T), elementType<T>().texelBytes, ElementType::Scalar::Float, GL_NONE};
}

/// The format of the texture of a buffer with such elements: GL_RGBA32F, GL_R32UI, ...
GLenum texelFormat(const ElementType& element);

/// Contents of the buffers of Lifetime::State in a table, by their names.
using BufferState = std::map<std::string, std::vector<std::byte>>;

/// How long the contents of a buffer matter. Steps that begin with the same state in all of them end with the same.
enum class Lifetime {
    Constant,  ///< Filled once, and only read by kernels.
    State,     ///< Carried on from step to step.
    Scratch,   ///< Written before it is read, in every step (by the renderer: in every frame).
};

/// Buffers and textures by their names in kernels and draw passes. A storage block `Positions` and a sampler
/// `positions` both mean the buffer "positions"; so does a sampler `lastPositions`, for kernels that write what they
/// read. Such kernels read only elements that the same thread writes, or that no thread writes.
class BufferTable {
public:
    struct Entry {
        RawBuffer* buffer = nullptr;
        ElementType element;
        Lifetime lifetime = Lifetime::Scratch;
    };

    /// @throws std::logic_error if a buffer has that name already.
    void add(const std::string& name, RawBuffer& buffer, ElementType element, Lifetime lifetime);
    /// Adds each under its label. The buffers must outlive the kernels; kernels notice assignments to them.
    template <typename... T>
    void add(Lifetime lifetime, Buffer<T>&... buffers)
    {
        (add(buffers.label(), buffers, elementType<T>(), lifetime), ...);
    }
    /// The same for structs of floats only.
    template <typename... T>
    void addFloatStructs(Lifetime lifetime, Buffer<T>&... buffers)
    {
        (add(buffers.label(), buffers, floatStructType<T>(), lifetime), ...);
    }
    /// Adds each under its label, for samplers of pictures.
    template <typename... T>
    void add(const Texture& texture, const T&... others)
    {
        textures_[texture.label()] = &texture;
        if constexpr (sizeof...(others) > 0) add(others...);
    }
    /// @throws DeviceError for an unknown name, saying which kernel or pass asked.
    const Entry& find(const std::string& name, const std::string& user) const;
    const Texture& findTexture(const std::string& name, const std::string& user) const;
    /// A table of only the named buffers and textures, for a pass that uses nothing else.
    BufferTable only(const std::vector<std::string>& names, const std::string& user) const;
    /// Stalls until the GPU is done.
    BufferState saveState() const;
    /// Writes nothing if it throws. @throws std::logic_error if the state is not of the same buffers, or of other
    /// sizes.
    void loadState(const BufferState& state) const;
    const std::map<std::string, Entry>& entries() const& { return entries_; }
    const std::map<std::string, Entry>& entries() && = delete;  // would outlive the table

private:
    std::map<std::string, Entry> entries_;
    std::map<std::string, const Texture*> textures_;
};

}  // namespace knuckle
