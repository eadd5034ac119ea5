#pragma once

namespace knuckle {

/// From now on an allocation that fails ends the program with one line and exit code 1. Under a limit of the address
/// space, software drivers may crash where one of theirs fails: that ends it likewise, if memory is short; any other
/// crash is one as before. What libraries say on standard error is not heard under such a limit.
void tellCrashesForWantOfMemory();

}  // namespace knuckle
