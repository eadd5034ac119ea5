#include "sim/gpu/shader_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string_view>

#include "sim/base/errors.h"
#include "sim/base/fnv_hash.h"

namespace knuckle {

// Generated from shaders/ by cmake/embed.cmake.
const std::map<std::string, std::string_view>& embeddedShaders();

std::string ResolvedShader::translate(const std::string& log) const
{
    // Mesa: "0:17(3): error"; NVIDIA: "0(17) : error".
    static const std::regex place(R"((\d+):(\d+)\((\d+)\)|(\d+)\((\d+)\))");
    std::string out;
    auto begin = std::sregex_iterator(log.begin(), log.end(), place);
    size_t copied = 0;
    for (auto it = begin; it != std::sregex_iterator(); ++it) {
        const std::string number = (*it)[2].matched ? (*it)[2].str() : (*it)[5].str();
        const size_t line = number.size() > 6 ? 0 : std::stoul(number);
        out += log.substr(copied, static_cast<size_t>(it->position()) - copied);
        out += line >= 1 && line <= origins.size()
                   ? fmt::format("shaders/{}:{}", origins[line - 1].file, origins[line - 1].line)
                   : it->str();
        copied = static_cast<size_t>(it->position() + it->length());
    }
    return out + log.substr(copied);
}

uint64_t ShaderSource::hash() const
{
    FnvHash hash;
    for (const auto& [path, text] : embeddedShaders()) {
        hash.add(std::string_view(path));
        hash.add(std::string_view(read(path)));
    }
    return hash.value();
}

std::string ShaderSource::read(const std::string& path) const
{
    if (!folder_.empty()) {
        std::ifstream file(folder_ + "/" + path, std::ios::binary);
        if (file) return {std::istreambuf_iterator<char>(file), {}};
    }
    const auto found = embeddedShaders().find(path);
    if (found == embeddedShaders().end())
        throw DeviceError(fmt::format("shader {} is neither in the program nor in \"{}\"", path, folder_));
    return std::string(found->second);
}

void ShaderSource::append(const std::string& path, ResolvedShader& out, std::vector<std::string>& seen) const
{
    if (std::find(seen.begin(), seen.end(), path) != seen.end()) return;
    seen.push_back(path);
    static const std::regex include(R"re(^\s*#\s*include\s+"([^"]+)")re");
    std::istringstream lines(read(path));
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::smatch match;
        if (line.find("#include \"") != std::string::npos && std::regex_search(line, match, include)) {
            append(match[1], out, seen);
            continue;
        }
        // GLSL cannot include the system headers of files shared with C++.
        if (line.starts_with("#include <")) continue;
        out.text += line + "\n";
        out.origins.push_back({path, number});
    }
}

ResolvedShader ShaderSource::resolve(const std::string& path, const Defines& defines) const
{
    ResolvedShader out;
    const auto add = [&](const std::string& line) {
        out.text += line + "\n";
        out.origins.push_back({path, 0});
    };
    add("#version 430 core");
    for (const auto& [name, value] : defines) add(fmt::format("#define {} {}", name, value));
    std::vector<std::string> seen;
    append(path, out, seen);
    return out;
}

}  // namespace knuckle
