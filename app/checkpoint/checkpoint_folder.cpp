#include "app/checkpoint/checkpoint_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "sim/base/errors.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

constexpr const char *NEXT = "next", *CURRENT = "current", *BEFORE = "before";
constexpr const char* FACTS = "checkpoint";

CheckpointFacts readFacts(const BlockReader& file)
{
    try {
        const Json json = parseJson(file.readText(FACTS), file.path());
        return {.fingerprint = RunFingerprint::read(json.at("fingerprint"), file.path()),
                .words = json.at("words"),
                .frame = json.at("frame"),
                .logBytes = json.at("log")};
    } catch (const Json::exception& error) {
        file.refuse(fmt::format("is not as this program writes it ({})", error.what()));
    }
}

pid_t readProcess(int file)
{
    std::array<char, 32> text{};
    if (pread(file, text.data(), text.size() - 1, 0) <= 0) return 0;
    return static_cast<pid_t>(std::strtol(text.data(), nullptr, 10));
}

}  // namespace

CheckpointFolder::CheckpointFolder(const std::string& path, const std::vector<std::string>& outputs) : path_(path)
{
    requireWritableFolder(path_);
    lock_ = FileDescriptor(open((path_ + "/lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
    if (lock_.get() < 0) throw InputError(fmt::format("{} cannot be written: {}", path_, std::strerror(errno)));
    const pid_t process = readProcess(lock_.get());
    if (flock(lock_.get(), LOCK_EX | LOCK_NB) != 0)
        throw InputError(
            fmt::format("{}: process {} is at this run; wait for it, or name another output", path_, process));
    removeTemporaries(path_, process);
    for (const std::string& folder : outputs) removeTemporaries(folder, process);
    const std::string own = std::to_string(getpid());
    if (ftruncate(lock_.get(), 0) != 0 || pwrite(lock_.get(), own.data(), own.size(), 0) < 0)
        throw InputError(fmt::format("{} cannot be written: {}", path_, std::strerror(errno)));
}

std::vector<FoundCheckpoint> CheckpointFolder::find(std::vector<std::string>& complaints) const
{
    std::vector<FoundCheckpoint> found;
    for (const char* part : {NEXT, CURRENT, BEFORE}) {
        if (!fs::exists(name(part))) continue;
        try {
            FoundCheckpoint checkpoint;
            checkpoint.state = std::make_unique<BlockReader>(name(part));
            checkpoint.facts = readFacts(*checkpoint.state);
            checkpoint.log = std::make_unique<BlockReader>(log(), checkpoint.facts.logBytes);
            found.push_back(std::move(checkpoint));
        } catch (const InputError& error) {
            complaints.emplace_back(error.what());
        }
    }
    return found;
}

void CheckpointFolder::write(const CheckpointFacts& facts, const RunState& state) const
{
    const Json json = {{"fingerprint", facts.fingerprint.json()},
                       {"words", facts.words},
                       {"frame", facts.frame},
                       {"log", facts.logBytes}};
    BlockWriter writer(name(NEXT));
    writer.add(packText(FACTS, json.dump(1)));
    for (const std::string& block : packState(state)) writer.add(block);
    writer.commitDurably();
    std::error_code failure;
    fs::rename(name(CURRENT), name(BEFORE), failure);  // the first has none before it
    fs::rename(name(NEXT), name(CURRENT), failure);
    if (failure) throw RunError(fmt::format("{} cannot be written: {}", name(CURRENT), failure.message()));
}

void CheckpointFolder::clear() const
{
    for (const char* part : {NEXT, CURRENT, BEFORE}) std::remove(name(part).c_str());
    std::remove(log().c_str());
}

std::string checkpointPath(std::string output)
{
    while (output.size() > 1 && output.ends_with('/')) output.pop_back();
    return output + ".checkpoint";
}

}  // namespace knuckle
