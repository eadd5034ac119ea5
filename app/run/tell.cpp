#include "app/run/tell.h"

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace knuckle {

void flushStandardOutput()
{
    if (std::fflush(stdout) != 0)
        throw std::system_error(errno, std::generic_category(), "standard output cannot be written");
}

void tellUser(const std::string& line)
{
    flushStandardOutput();
    std::fputs((line + "\n").c_str(), stderr);
}

}  // namespace knuckle
