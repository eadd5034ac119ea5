#include "tests/places.h"

namespace knuckle::test {

std::string inSource(const std::string& file)
{
    return std::string(KNUCKLE_ROOT) + "/" + file;
}

const std::string& programPath()
{
    static const std::string path = KNUCKLE_PROGRAM;
    return path;
}

}  // namespace knuckle::test
