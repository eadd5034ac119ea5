#include "sim/base/json.h"

#include <stdexcept>
#include <string>

namespace knuckle {

void requireJson(bool holds, const char* condition)
{
    if (!holds) throw std::logic_error(std::string("JSON is read against its form: ") + condition);
}

}  // namespace knuckle
