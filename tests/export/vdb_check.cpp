// Prints what a file of --export vdb has, for test_vdb.py: a line for each point (id, place, velocity), the number of
// points, and the volume of the level set. vdb_check FILE
#include <openvdb/openvdb.h>
#include <openvdb/points/PointAttribute.h>
#include <openvdb/points/PointCount.h>
#include <openvdb/tools/LevelSetMeasure.h>

#include <cstdio>

namespace {

void printPoints(const openvdb::points::PointDataGrid& grid)
{
    using namespace openvdb::points;
    for (auto leaf = grid.tree().cbeginLeaf(); leaf; ++leaf) {
        const AttributeHandle<openvdb::Vec3f> places(leaf->constAttributeArray("P")),
            velocities(leaf->constAttributeArray("velocity"));
        const AttributeHandle<int32_t> ids(leaf->constAttributeArray("id"));
        for (auto index = leaf->beginIndexOn(); index; ++index) {
            const openvdb::Vec3d at = grid.transform().indexToWorld(index.getCoord().asVec3d() + places.get(*index));
            const openvdb::Vec3f v = velocities.get(*index);
            std::printf("point %d %.9g %.9g %.9g %.9g %.9g %.9g\n", ids.get(*index), at.x(), at.y(), at.z(), v.x(),
                        v.y(), v.z());
        }
    }
    std::printf("points %llu\n", static_cast<unsigned long long>(pointCount(grid.tree())));
}

}  // namespace

int main(int /*count*/, char** words)
{
    openvdb::initialize();
    openvdb::io::File file(words[1]);
    file.open();
    const openvdb::GridPtrVecPtr grids = file.getGrids();
    for (const openvdb::GridBase::Ptr& grid : *grids) {
        if (const auto points = openvdb::gridPtrCast<openvdb::points::PointDataGrid>(grid)) printPoints(*points);
        if (const auto fluid = openvdb::gridPtrCast<openvdb::FloatGrid>(grid))
            std::printf("fluid %d %.9g\n", fluid->getGridClass() == openvdb::GRID_LEVEL_SET,
                        openvdb::tools::levelSetVolume(*fluid));
    }
    return 0;
}
