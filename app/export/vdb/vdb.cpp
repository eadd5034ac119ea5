#include "app/export/vdb/vdb.h"

#include <fmt/format.h>

#include "app/export/surface/surface.h"
#include "app/export/vdb/vdb_file.h"
#include "sim/base/errors.h"

namespace knuckle {

void VdbExport::begin(const Scene& scene)
{
    if (!canWriteVdb())
        throw InputError(fmt::format("--export vdb={}: this program was built without OpenVDB; install libopenvdb-dev "
                                     "and libboost-dev, and build it again, which finds them",
                                     path()));
    FolderExport::begin(scene);
}

void VdbExport::frame(const ExportFrame& frame)
{
    const ParticleState& state = *frame.particles;
    VdbFrame out;
    out.pointVoxel = 2.0f * frame.world.diameter();
    for (uint32_t i = 0; i < state.positions.size(); ++i) {
        if (state.inactive[i]) continue;
        out.ids.push_back(static_cast<int32_t>(i));
        out.places.push_back(state.positions[i]);
        out.velocities.push_back(state.velocities[i]);
    }
    if (frame.world.fluidCount > 0) {
        const FluidField field(dropsOf(frame.world, *frame.view), frame.world.fluidSpacing);
        out.fluid = surfaceOf(field);
        out.fluidVoxel = field.step();
    }
    OutputFile file(names().path(frame.number));
    writeVdb(file.temporaryName(), out);
    file.commit();
}

}  // namespace knuckle
