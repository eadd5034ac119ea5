#include "app/sweep/claim.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "sim/base/errors.h"
#include "sim/base/files/leftovers.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

constexpr double NANOSECONDS = 1e9;

std::string textOf(const std::string& path)
{
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

int64_t timeOf(int file)
{
    struct stat facts = {};
    if (fstat(file, &facts) != 0) return 0;
    return int64_t{facts.st_mtim.tv_sec} * 1000000000 + facts.st_mtim.tv_nsec;
}

/// When a process was started [ticks since the machine was]; empty: it is not there, or only waits to be buried.
std::string startOf(pid_t process)
{
    const std::string stat = textOf(fmt::format("/proc/{}/stat", process));
    const size_t name = stat.rfind(')');  // a name may have anything in it
    if (name == std::string::npos) return {};
    std::istringstream fields(stat.substr(name + 1));
    std::string field;
    constexpr int STATE = 3, START = 22;  // of proc(5)
    for (int k = STATE; k <= START && fields >> field; ++k)
        if (k == STATE && (field == "Z" || field == "X")) return {};
    return field;
}

[[noreturn]] void failAtFile(const std::string& path, int error)
{
    throw RunError(fmt::format("{} cannot be written: {}", path, std::strerror(error)));
}

}  // namespace

Worker Worker::self()
{
    std::array<char, 256> host{};
    gethostname(host.data(), host.size() - 1);
    std::error_code ignored;
    std::string boot = textOf("/proc/sys/kernel/random/boot_id");
    while (boot.ends_with('\n')) boot.pop_back();
    const std::string processes = fs::read_symlink("/proc/self/ns/pid", ignored).string();
    return {host.data(), boot.empty() ? "" : boot + " " + processes, getpid(), startOf(getpid())};
}

Worker Worker::of(const Json& json)
{
    if (!json.is_object()) return {};
    return {json.value("host", ""), json.value("place", ""), json.value("process", pid_t{0}),
            json.value("started", "")};
}

Json Worker::json() const
{
    return {{"host", host}, {"place", place}, {"process", process}, {"started", started}};
}

bool Worker::isThere() const
{
    return !started.empty() && startOf(process) == started;
}

std::optional<Claim> Claim::take(const std::string& folder, uint64_t number, const Worker& worker)
{
    const std::string path = claimPath(folder, number);
    FileDescriptor file(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.get() < 0 && errno == EEXIST) return {};
    if (file.get() < 0) failAtFile(path, errno);
    if (const int error = writeAll(file.get(), worker.json().dump() + "\n"); error != 0) {
        unlink(path.c_str());
        failAtFile(path, error);
    }
    return Claim(folder, number, std::move(file));
}

bool Claim::renew() const
{
    std::error_code ignored;
    if (fs::exists(claimPath(folder_, number_ + 1), ignored)) return false;
    futimens(file_.get(), nullptr);  // if it fails, others take over, which is right
    return true;
}

std::string claimPath(const std::string& folder, uint64_t number)
{
    return fmt::format("{}/claim.{}", folder, number);
}

bool ClaimSeen::isLeft(const Worker& self, double staleSeconds) const
{
    if (worker.isBeside(self)) return !worker.isThere();
    return age > staleSeconds;
}

std::optional<ClaimSeen> readClaim(const std::string& folder, uint64_t number, int64_t now)
{
    const std::string path = claimPath(folder, number);
    // Opened, so that shared storage says how it is now.
    const FileDescriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.get() < 0) return {};
    const Json json = Json::parse(textOf(path), nullptr, false);
    ClaimSeen seen{json.is_discarded() ? Worker() : Worker::of(json)};
    seen.renewed = timeOf(file.get());
    seen.age = static_cast<double>(now - seen.renewed) / NANOSECONDS;
    return seen;
}

int64_t storedNow(const std::string& folder)
{
    std::error_code ignored;
    const std::string path = fs::absolute(fmt::format("{}/.knuckle_now_{}", folder, getpid()), ignored).string();
    const Leftover leftover(path);
    const FileDescriptor file(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (file.get() < 0) {
        const auto now = std::chrono::system_clock::now().time_since_epoch();
        return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
    }
    futimens(file.get(), nullptr);
    const int64_t now = timeOf(file.get());
    unlink(path.c_str());
    return now;
}

}  // namespace knuckle
