#include "sim/gpu/program.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "sim/world/errors.h"

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

GLuint compileShader(const Gpu& gpu, GLenum stage, const std::string& path, const Defines& defines)
{
    const ResolvedShader source = gpu.shaders().resolve(path, defines);
    const GLuint shader = glCreateShader(stage);
    const char* text = source.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (ok) return shader;
    const std::string log = source.translate(infoLog(shader, false));
    glDeleteShader(shader);
    throw DeviceError(fmt::format("shader {} does not compile on {}: {}", path, gpu.device().name, log));
}

GLuint link(const Gpu& gpu, const std::string& name, std::initializer_list<GLuint> shaders)
{
    const GLuint program = glCreateProgram();
    for (GLuint shader : shaders) glAttachShader(program, shader);
    glLinkProgram(program);
    for (GLuint shader : shaders) glDeleteShader(shader);
    GLint ok = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    if (!ok) {
        const std::string log = infoLog(program, true);
        glDeleteProgram(program);
        throw DeviceError(fmt::format("program {} does not link on {}: {}", name, gpu.device().name, log));
    }
    glObjectLabel(GL_PROGRAM, program, -1, name.c_str());
    return program;
}

}  // namespace

Program Program::compute(const Gpu& gpu, const std::string& path, const Defines& defines)
{
    Program program;
    program.name_ = std::filesystem::path(path).stem().string();
    program.id_ = link(gpu, program.name_, {compileShader(gpu, GL_COMPUTE_SHADER, path, defines)});
    return program;
}

Program Program::graphics(const Gpu& gpu, const std::string& vertexPath, const std::string& fragmentPath,
                          const Defines& defines)
{
    Program program;
    program.name_ = std::filesystem::path(fragmentPath).stem().string();
    const GLuint vertex = compileShader(gpu, GL_VERTEX_SHADER, vertexPath, defines);
    program.id_ = link(gpu, program.name_, {vertex, compileShader(gpu, GL_FRAGMENT_SHADER, fragmentPath, defines)});
    return program;
}

Program::~Program()
{
    if (id_ != 0) glDeleteProgram(id_);
}

Program::Program(Program&& other) noexcept : id_(std::exchange(other.id_, 0)), name_(std::move(other.name_)) {}

Program& Program::operator=(Program&& other) noexcept
{
    std::swap(id_, other.id_);
    std::swap(name_, other.name_);
    return *this;
}

}  // namespace knuckle
