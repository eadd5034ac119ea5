#pragma once

#include <epoxy/gl.h>

#include <string>

#include "sim/gpu/gl_handle.h"
#include "sim/gpu/gpu.h"

namespace knuckle {

/// A linked GL program, named after its first file. @throws DeviceError with the log in file:line of the real files.
class Program {
public:
    Program() = default;
    static Program compute(const Gpu& gpu, const std::string& path, const Defines& defines = {});
    static Program graphics(const Gpu& gpu, const std::string& vertexPath, const std::string& fragmentPath,
                            const Defines& defines = {});

    GLuint id() const { return handle_.id(); }
    const std::string& name() const { return name_; }
    /// -1 when the program has no such active uniform (GL ignores writes to -1).
    GLint uniform(const char* name) const { return glGetUniformLocation(id(), name); }

private:
    ProgramHandle handle_;
    std::string name_;
};

}  // namespace knuckle
