#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/gpu/buffer_table.h"
#include "sim/gpu/program.h"

namespace knuckle {

/// {"cell", "fluidCell"}: a program that declares "cellStarts" gets "fluidCellStarts". So kernels that work on buffers
/// of two kinds use one name.
using Renames = std::vector<std::pair<std::string, std::string>>;

/// Small buffers instead of those of a table, of a context that shares them with no other: while kernels are compiled.
class Placeholders {
public:
    /// @param format of its texture; GL_NONE for none.
    const RawBuffer& of(const RawBuffer& buffer, GLenum format);

private:
    std::map<std::pair<GLenum, size_t>, RawBuffer> made_;  ///< By format and size.
};

/// Resources of a program: its storage blocks, uniform blocks, samplers and images of buffers, each found in a table by
/// its name. Refers to the buffers and textures: after an assignment to one, it binds the new one by itself.
class Bindings {
public:
    Bindings() = default;
    /// @param user names the kernel or pass in errors.
    /// @throws DeviceError for a block or sampler that the table does not have, or has with another type of element.
    Bindings(const Program& program, const BufferTable& table, const std::string& user, Renames renames = {});

    size_t storageCount() const { return storage_.size(); }
    size_t textureCount() const { return samplers_.size(); }
    size_t imageCount() const { return images_.size(); }
    /// @param user names the kernel or pass. @throws DeviceError for a buffer that the device cannot bind as a whole.
    void checkSizes(const Gpu& gpu, const std::string& user) const;
    /// Binds all for the next dispatch or draw call.
    void bind() const;
    /// Binds others than its buffers, for which a driver compiles the same code.
    void bind(Placeholders& others) const;

private:
    struct Sampled {
        const RawBuffer* buffer = nullptr;  ///< Null for a picture.
        GLenum format = GL_R32F;
        const Texture* picture = nullptr;
        uint32_t texelBytes = 0;  ///< Of a buffer.
    };
    void findStorage(const BufferTable& table, const std::string& user);
    void findUniforms(const BufferTable& table, const std::string& user);
    void findSamplers(const BufferTable& table, const std::string& user);
    void findImages(const BufferTable& table, const std::string& user);
    /// @param as gives the buffer that is bound for one of these with that format.
    template <typename As>
    void bindAs(const As& as) const;

    /// Name in the table of an active resource.
    std::string resourceName(GLenum interface, GLuint index) const;

    GLuint program_ = 0;
    Renames renames_;
    std::vector<const RawBuffer*> storage_, uniforms_;  ///< Position is binding point, as in samplers_.
    std::vector<Sampled> samplers_, images_;
};

}  // namespace knuckle
