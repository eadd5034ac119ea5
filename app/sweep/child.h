#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace knuckle {

/// The path of this program.
std::string ownProgram();

/// Starts this program once more, to end with this process: when this one is killed, it is too. It has a group of its
/// own, so that Ctrl-C reaches it through stopChild() alone.
/// @param words its name and arguments. @param log where all that it says is added. @throws RunError.
pid_t startChild(const std::vector<std::string>& words, const std::string& log);

/// Asks it to finish its frame, write a checkpoint and end. Counts as no second signal for one that was asked already.
void stopChild(pid_t child);

}  // namespace knuckle
