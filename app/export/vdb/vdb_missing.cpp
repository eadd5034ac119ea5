#include <stdexcept>

#include "app/export/vdb/vdb_file.h"

namespace knuckle {

bool canWriteVdb()
{
    return false;
}

void writeVdb(const std::string& /*path*/, const VdbFrame& /*frame*/)
{
    throw std::logic_error("this program was built without OpenVDB");
}

}  // namespace knuckle
