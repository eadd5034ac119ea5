#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>

#include "app/doctor/bounded.h"
#include "app/doctor/machine_findings.h"
#include "app/run/driver_report.h"
#include "sim/base/memory.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

/// What small scenes take with llvmpipe, which is half of it [bytes].
constexpr uint64_t MEMORY = uint64_t{512} << 20;
constexpr rlim_t FILES = 256;
/// A live scene, or a film with its encoder.
constexpr uint64_t THREADS = 128;
constexpr int THREAD_SECONDS = 5;

std::string variable(const char* name)
{
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
}

std::optional<uint64_t> numberIn(const std::string& file)
{
    uint64_t number = 0;
    std::ifstream stream(file);
    if (stream >> number) return number;
    return {};
}

/// The memory that can still be had: of the machine, or of the container's share [bytes].
std::optional<uint64_t> availableMemory()
{
    std::optional<uint64_t> available;
    std::ifstream lines("/proc/meminfo");
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        uint64_t kibibytes = 0;
        if (std::string key; words >> key >> kibibytes && key == "MemAvailable:") available = kibibytes << 10;
    }
    for (const auto& [most, used] :
         {std::pair{"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current"},
          std::pair{"/sys/fs/cgroup/memory/memory.limit_in_bytes", "/sys/fs/cgroup/memory/memory.usage_in_bytes"}}) {
        const auto limit = numberIn(most), taken = numberIn(used);
        if (limit && taken) available = std::min(available.value_or(UINT64_MAX), *limit > *taken ? *limit - *taken : 0);
    }
    return available;
}

void findMemory(Findings& findings)
{
    if (const auto available = availableMemory()) {
        const bool isEnough = *available >= MEMORY;
        findings.push_back({isEnough ? Health::Ok : Health::Wrong,
                            fmt::format("memory: {} MiB are free", *available >> 20),
                            isEnough ? ""
                                     : fmt::format("small scenes take up to {} MiB: end other programs, or give "
                                                   "the container more",
                                                   MEMORY >> 20)});
    }
    if (const auto limit = addressSpaceLimit()) {
        const bool isEnough = *limit >= addressSpaceInUse() + MEMORY;
        findings.push_back({isEnough ? Health::Note : Health::Wrong,
                            fmt::format("address space is limited to {} MiB", *limit >> 20),
                            isEnough ? "" : "raise it (ulimit -v unlimited)"});
    }
}

/// Of this user, or of the container, threads of others among them.
std::optional<uint64_t> threadLimit()
{
    std::optional<uint64_t> most = numberIn("/sys/fs/cgroup/pids.max");
    if (!most) most = numberIn("/sys/fs/cgroup/pids/pids.max");
    rlimit own{};
    const bool isLimited = geteuid() != 0 && getrlimit(RLIMIT_NPROC, &own) == 0 && own.rlim_cur != RLIM_INFINITY;
    if (isLimited) most = std::min<uint64_t>(most.value_or(UINT64_MAX), own.rlim_cur);
    return most;
}

void findLimits(Findings& findings)
{
    rlimit files{};
    if (getrlimit(RLIMIT_NOFILE, &files) == 0) {
        const bool isEnough = files.rlim_cur == RLIM_INFINITY || files.rlim_cur >= FILES;
        const std::string count = files.rlim_cur == RLIM_INFINITY ? "any number" : std::to_string(files.rlim_cur);
        findings.push_back({isEnough ? Health::Ok : Health::Wrong, fmt::format("open files: {} allowed", count),
                            isEnough ? "" : "raise it (ulimit -n 1024)"});
    }
    if (const auto threads = threadLimit()) {
        const bool isEnough = *threads >= THREADS;
        findings.push_back({isEnough ? Health::Ok : Health::Wrong,
                            fmt::format("processes and threads: {} allowed", *threads),
                            isEnough ? "" : "allow more (ulimit -u; of a container --pids-limit)"});
    }
    rlimit size{};
    if (getrlimit(RLIMIT_FSIZE, &size) == 0 && size.rlim_cur != RLIM_INFINITY)
        findings.push_back({Health::Note, fmt::format("files may have {} KiB at most", size.rlim_cur >> 10),
                            "raise it (ulimit -f unlimited) where films are longer"});
}

/// Where Mesa keeps compiled shaders.
std::string shaderCache()
{
    if (std::string folder = variable("MESA_SHADER_CACHE_DIR"); !folder.empty()) return folder;
    if (std::string folder = variable("XDG_CACHE_HOME"); !folder.empty()) return folder;
    const std::string home = variable("HOME");
    return home.empty() ? "" : home + "/.cache";
}

void findShaderCache(Findings& findings)
{
    constexpr const char* REMEDY = "set MESA_SHADER_CACHE_DIR to a folder that can be written: without it each run "
                                   "compiles all shaders anew";
    const std::string off = variable("MESA_SHADER_CACHE_DISABLE");
    if (off == "1" || off == "true") {
        findings.push_back({Health::Note, "shader cache: MESA_SHADER_CACHE_DISABLE is set, so each run compiles anew"});
        return;
    }
    const std::string folder = shaderCache();
    if (folder.empty()) {
        findings.push_back({Health::Note, "shader cache: there is no HOME", REMEDY});
        return;
    }
    std::error_code error;
    fs::path there = fs::absolute(folder, error);
    while (!fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
    if (fs::is_directory(there, error) && access(there.c_str(), W_OK | X_OK) == 0)
        findings.push_back({Health::Ok, fmt::format("shader cache: in {}", folder)});
    else findings.push_back({Health::Note, fmt::format("shader cache: {} cannot be written", folder), REMEDY});
}

/// Whether somebody listens on a port of this machine.
bool isListenedOn(uint16_t port)
{
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    const int connection = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const bool answered = connection >= 0 &&
                          connect(connection, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    if (connection >= 0) close(connection);
    return answered;
}

/// Whether an X server may be where this leads. Of other machines nobody is asked.
bool leadsToDisplay(const std::string& display)
{
    constexpr uint16_t FIRST_PORT = 6000;
    const size_t colon = display.rfind(':');
    if (colon == std::string::npos) return false;
    const std::string host = display.substr(0, colon);
    uint16_t number = 0;
    if (std::from_chars(display.data() + colon + 1, display.data() + display.size(), number).ec != std::errc{})
        return false;
    std::error_code ignored;
    if (host.empty() || host == "unix") return fs::exists(fmt::format("/tmp/.X11-unix/X{}", number), ignored);
    return (host != "localhost" && host != "127.0.0.1") || isListenedOn(static_cast<uint16_t>(FIRST_PORT + number));
}

/// Displays are not needed, whatever these say.
void findDisplays(Findings& findings)
{
    std::error_code ignored;
    const auto note = [&](const std::string& setting) {
        findings.push_back({Health::Note, setting + " points nowhere, which does not matter: no window is opened"});
    };
    const std::string x = variable("DISPLAY"), wayland = variable("WAYLAND_DISPLAY");
    if (!x.empty() && !leadsToDisplay(x)) note("DISPLAY=" + x);
    if (wayland.empty()) return;
    const std::string socket = wayland[0] == '/' ? wayland : variable("XDG_RUNTIME_DIR") + "/" + wayland;
    if (!fs::exists(socket, ignored)) note("WAYLAND_DISPLAY=" + wayland);
}

}  // namespace

Findings findMachine(bool software)
{
    Findings findings;
    if (software) {
        const BoundedResult threads = runBounded(threadsText, THREAD_SECONDS);
        if (threads.failure.empty()) findings.push_back({Health::Ok, "driver threads: " + threads.text});
        else
            findings.push_back({Health::Wrong, "driver threads: " + threads.failure,
                                "allow more processes (ulimit -u), or set LP_NUM_THREADS=0"});
    }
    findMemory(findings);
    findLimits(findings);
    findShaderCache(findings);
    findDisplays(findings);
    return findings;
}

}  // namespace knuckle
