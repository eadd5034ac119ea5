#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>

#include "app/json/json.h"
#include "sim/base/files/file_descriptor.h"

namespace knuckle {

/// Who works: a process, as others on the same or another machine can find out whether it is still there.
struct Worker {
    std::string host;   ///< For people.
    std::string place;  ///< Same for processes that see each other's numbers: of the machine's start, of the container.
    pid_t process = 0;
    std::string started;  ///< When, in the machine's own count: numbers of processes are used again.

    static Worker self();
    static Worker of(const Json& json);
    Json json() const;
    bool operator==(const Worker&) const = default;
    /// Whether both see the same processes, so that isThere() can be asked.
    bool isBeside(const Worker& other) const { return !place.empty() && place == other.place; }
    /// Of one on this machine.
    bool isThere() const;
};

/// A part of the work that is this process's: a file that only one could make. Claims of one thing have numbers; the
/// highest is whose it is, so that who was taken for dead and comes back sees it.
class Claim {
public:
    /// Makes the file FOLDER/claim.NUMBER. @returns none if it is there already. @throws RunError (full disk).
    static std::optional<Claim> take(const std::string& folder, uint64_t number, const Worker& worker);

    uint64_t number() const { return number_; }
    /// Says that its owner still works. @returns false if another has taken it over.
    bool renew() const;

private:
    Claim(std::string folder, uint64_t number, FileDescriptor file)
        : folder_(std::move(folder)), number_(number), file_(std::move(file))
    {
    }

    std::string folder_;
    uint64_t number_;
    FileDescriptor file_;
};

std::string claimPath(const std::string& folder, uint64_t number);

/// A claim as others see it.
struct ClaimSeen {
    Worker worker;
    double age = 0.0;     ///< Since it was renewed [s], by the clock of what stores it.
    int64_t renewed = 0;  ///< When, by that clock [ns].

    /// Whether its owner has gone: on this machine its process, on another it has not been renewed for so long.
    bool isLeft(const Worker& self, double staleSeconds) const;
};

/// @param now of storedNow(). @returns none if it cannot be read.
std::optional<ClaimSeen> readClaim(const std::string& folder, uint64_t number, int64_t now);

/// The time by the clock that files in the folder get theirs from, which of shared storage is another than this
/// machine's [ns]. This machine's where nothing can be written.
int64_t storedNow(const std::string& folder);

}  // namespace knuckle
