#pragma once

namespace knuckle {

/// Under a limit of the address space, software drivers may crash where an allocation of theirs fails. From now on that
/// ends the program with one line and exit code 1, if memory is short; any other crash is one as before. What libraries
/// say on standard error is not heard then.
void tellCrashesForWantOfMemory();

}  // namespace knuckle
