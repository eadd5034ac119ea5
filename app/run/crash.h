#pragma once

namespace knuckle {

/// From now on an allocation that fails ends the program with one line and exit code 1. Under a limit of the address
/// space, software drivers may crash when an allocation of theirs fails: this ends the program in the same way, if
/// memory is short; other crashes stay as they are. Under such a limit, libraries' messages on standard error are
/// dropped.
void tellCrashesForWantOfMemory();

}  // namespace knuckle
