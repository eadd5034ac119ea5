#include "app/export/vdb/vdb_file.h"

#include <openvdb/openvdb.h>
#include <openvdb/points/PointConversion.h>
#include <openvdb/tools/MeshToVolume.h>

#include <fstream>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

using openvdb::Vec3s;
using openvdb::points::PointAttributeVector;
using openvdb::points::PointDataGrid;

std::vector<Vec3s> vectorsOf(const std::vector<Eigen::Vector3f>& vectors)
{
    std::vector<Vec3s> out;
    for (const Eigen::Vector3f& v : vectors) out.emplace_back(v.x(), v.y(), v.z());
    return out;
}

template <typename T>
void addAttribute(PointDataGrid& points, const openvdb::tools::PointIndexGrid& order, const char* name,
                  const std::vector<T>& values)
{
    openvdb::points::appendAttribute(points.tree(), name, openvdb::points::TypedAttributeArray<T>::attributeType());
    openvdb::points::populateAttribute(points.tree(), order.tree(), name, PointAttributeVector<T>(values));
}

openvdb::GridBase::Ptr pointsOf(const VdbFrame& frame)
{
    const std::vector<Vec3s> places = vectorsOf(frame.places);
    const auto transform = openvdb::math::Transform::createLinearTransform(frame.pointVoxel);
    const PointAttributeVector<Vec3s> wrapped(places);
    const auto order = openvdb::tools::createPointIndexGrid<openvdb::tools::PointIndexGrid>(wrapped, *transform);
    const auto points = openvdb::points::createPointDataGrid<openvdb::points::NullCodec, PointDataGrid>(*order, wrapped,
                                                                                                        *transform);
    addAttribute(*points, *order, "velocity", vectorsOf(frame.velocities));
    addAttribute(*points, *order, "id", frame.ids);
    points->setName("particles");
    return points;
}

openvdb::GridBase::Ptr levelSetOf(const VdbFrame& frame)
{
    std::vector<openvdb::Vec3I> triangles;
    for (const auto& [a, b, c] : frame.fluid.triangles) triangles.emplace_back(a, b, c);
    const auto transform = openvdb::math::Transform::createLinearTransform(frame.fluidVoxel);
    const auto grid = openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(*transform, vectorsOf(frame.fluid.places),
                                                                         triangles);
    grid->setName("fluid");
    return grid;
}

/// Files have an id by chance behind their magic number and versions: here it is always the same.
void replaceId(const std::string& path)
{
    constexpr std::streamoff BEFORE = 21;
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(BEFORE);
    file << "00000000-0000-0000-0000-000000000000";
    if (!file.flush()) throw RunError(path + " cannot be written");
}

}  // namespace

bool canWriteVdb()
{
    return true;
}

void writeVdb(const std::string& path, const VdbFrame& frame)
{
    openvdb::initialize();
    try {
        openvdb::GridPtrVec grids{pointsOf(frame)};
        if (frame.fluidVoxel > 0.0f) grids.push_back(levelSetOf(frame));
        openvdb::io::File(path).write(grids);
    } catch (const openvdb::Exception& error) {
        throw RunError(std::string("a file of OpenVDB cannot be written: ") + error.what());
    }
    replaceId(path);
}

}  // namespace knuckle
