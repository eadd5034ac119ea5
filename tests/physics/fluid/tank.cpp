#include "tests/physics/fluid/tank.h"

#include <cmath>

namespace knuckle::test {

Tank::Tank(int wide, int layers, int deep, const std::vector<float>& densities, const Settings& settings)
    : builder(makeBuilder(settings))
{
    for (float density : densities) {
        Material material;
        material.fluid = true;
        material.density = density;
        fluids.push_back(builder.addMaterial(material));
    }
    const float d = builder.fluidSpacing();
    width = d * static_cast<float>(wide);
    depth = d * static_cast<float>(deep);
    addWalls(builder, width, depth);
    const auto kinds = static_cast<int>(fluids.size());
    for (int k = 0; k < kinds; ++k) {
        std::vector<Vector3f> places;
        for (int y = layers * k / kinds; y < layers * (k + 1) / kinds; ++y)
            for (int z = 0; z < deep; ++z)
                for (int x = 0; x < wide; ++x) places.push_back(d * (lattice(x, y, z) + Vector3f::Constant(0.5f)));
        builder.addFluid(places, {0, 0, 0}, fluids[k]);
    }
}

void addPlane(WorldBuilder& builder, const Vector3f& place, const Vector3f& normal)
{
    Collider wall;
    wall.shape = ColliderShape::Plane;
    wall.position = place;
    wall.orientation = Quaternionf::FromTwoVectors(Vector3f::UnitY(), normal);
    builder.addCollider(wall);
}

void addWalls(WorldBuilder& builder, float width, float depth)
{
    const Vector3f far(width, 0, depth);
    for (const auto& [place, normal] : {std::pair<Vector3f, Vector3f>{{0, 0, 0}, {0, 1, 0}},
                                        {{0, 0, 0}, {1, 0, 0}},
                                        {far, {-1, 0, 0}},
                                        {{0, 0, 0}, {0, 0, 1}},
                                        {far, {0, 0, -1}}})
        addPlane(builder, place, normal);
}

Vector3f lattice(int x, int y, int z)
{
    return Eigen::Vector3i(x, y, z).cast<float>();
}

double rootMeanSquareSpeed(const ParticleState& state)
{
    double sum = 0.0;
    for (const Vector3f& v : state.velocities) sum += v.squaredNorm();
    return std::sqrt(sum / static_cast<double>(state.velocities.size()));
}

double meanHeight(const World& world, const ParticleState& state, uint32_t material)
{
    double sum = 0.0;
    int count = 0;
    for (size_t i = 0; i < world.particles.size(); ++i)
        if (world.particles[i].material == material) {
            sum += state.positions[i].y();
            ++count;
        }
    return sum / count;
}

double submerged(const BodyState& body, const Vector3f& size, double level)
{
    int below = 0;
    for (int k = 0; k < 8000; ++k) {
        const Vector3f p = lattice(k % 20, k / 20 % 20, k / 400) / 20.0f - Vector3f::Constant(0.475f);
        below += (body.position + body.rotation * p.cwiseProduct(size)).y() < level;
    }
    return below / 8000.0;
}

double submergedIn(const World& world, const BodyState& body, const Vector3f& size, double area)
{
    const double water = world.fluidCount * std::pow(world.fluidSpacing, 3.0);
    double level = water / area;
    for (int k = 0; k < 20; ++k) level = (water + submerged(body, size, level) * size.prod()) / area;
    return submerged(body, size, level);
}

}  // namespace knuckle::test
