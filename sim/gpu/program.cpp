#include "sim/gpu/program.h"

#include <fmt/format.h>

#include <filesystem>

#include "sim/gpu/device/driver_advice.h"

namespace knuckle {

namespace {

std::string infoLog(GLuint object, bool isProgram)
{
    GLint length = 0;
    if (isProgram) glGetProgramiv(object, GL_INFO_LOG_LENGTH, &length);
    else glGetShaderiv(object, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<size_t>(std::max(length, 1)), '\0');
    if (isProgram) glGetProgramInfoLog(object, length, nullptr, log.data());
    else glGetShaderInfoLog(object, length, nullptr, log.data());
    log.resize(log.find('\0') == std::string::npos ? log.size() : log.find('\0'));
    return log;
}

ShaderHandle compileShader(const Gpu& gpu, GLenum stage, const std::string& path, const Defines& defines)
{
    const ResolvedShader source = gpu.shaders().resolve(path, defines);
    ShaderHandle shader = ShaderHandle::make(stage);
    const char* text = source.text.c_str();
    glShaderSource(shader.id(), 1, &text, nullptr);
    glCompileShader(shader.id());
    GLint ok = 0;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &ok);
    if (ok) return shader;
    failOnDevice(fmt::format("shader {} does not compile on {}: {}", path, gpu.device().name,
                             source.translate(infoLog(shader.id(), false))));
}

template <typename... Shaders>
ProgramHandle link(const Gpu& gpu, const std::string& name, const Shaders&... shaders)
{
    ProgramHandle program = ProgramHandle::make();
    (glAttachShader(program.id(), shaders.id()), ...);
    glLinkProgram(program.id());
    GLint ok = 0;
    glGetProgramiv(program.id(), GL_LINK_STATUS, &ok);
    if (!ok)
        failOnDevice(
            fmt::format("program {} does not link on {}: {}", name, gpu.device().name, infoLog(program.id(), true)));
    (glDetachShader(program.id(), shaders.id()), ...);
    glObjectLabel(GL_PROGRAM, program.id(), -1, name.c_str());
    return program;
}

}  // namespace

Program Program::compute(const Gpu& gpu, const std::string& path, const Defines& defines)
{
    Program program;
    program.name_ = std::filesystem::path(path).stem().string();
    program.handle_ = link(gpu, program.name_, compileShader(gpu, GL_COMPUTE_SHADER, path, defines));
    return program;
}

Program Program::graphics(const Gpu& gpu, const std::string& vertexPath, const std::string& fragmentPath,
                          const Defines& defines)
{
    Program program;
    program.name_ = std::filesystem::path(fragmentPath).stem().string();
    program.handle_ = link(gpu, program.name_, compileShader(gpu, GL_VERTEX_SHADER, vertexPath, defines),
                           compileShader(gpu, GL_FRAGMENT_SHADER, fragmentPath, defines));
    return program;
}

}  // namespace knuckle
