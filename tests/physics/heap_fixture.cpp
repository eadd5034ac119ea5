#include "tests/physics/heap_fixture.h"

#include <algorithm>
#include <cmath>

#include "sim/world/matter/grain.h"
#include "tests/physics/closed/round_fixture.h"

namespace knuckle::test {

GrainFill::GrainFill(float mu, const Settings& settings) : builder_(makeBuilder(settings, mu))
{
    builder_.addCollider(floorPlane(mu));
}

void GrainFill::addGrain(const Vector3f& place)
{
    Particle grain;
    grain.position = grain.restPosition = place;
    grain.scale = grainScale(builder_.particleCount());
    builder_.addLooseParticle(grain);
}

void GrainFill::fill(const Vector3f& low, const Vector3f& high, float spacing,
                     const std::function<bool(const Vector3f&)>& has)
{
    const auto share = [&] { return static_cast<float>(random_() >> 8) * 0x1p-23f - 1.0f; };
    const Eigen::Vector3i counts = ((high - low) / spacing).array().round().cast<int>();
    for (int y = 0; y < counts.y(); ++y)
        for (int z = 0; z < counts.z(); ++z)
            for (int x = 0; x < counts.x(); ++x) {
                const float shift = y % 2 == 0 ? -0.125f : 0.125f;
                Vector3f place = low + spacing * (Eigen::Vector3i(x, y, z).cast<float>() + Vector3f(0.5f, 0.5f, 0.5f) +
                                                  Vector3f(shift, 0, shift));
                if (has && !has(place)) continue;
                for (float& side : place) side += 0.15f * share();
                addGrain(DIAMETER * place);
            }
}

void GrainFill::addWall(const Vector3f& low, const Vector3f& high, float friction)
{
    Collider wall;
    wall.shape = ColliderShape::Box;
    wall.position = 0.5f * DIAMETER * (low + high);
    wall.halfExtents = 0.5f * DIAMETER * (high - low);
    wall.staticFriction = wall.kineticFriction = friction;
    builder_.addCollider(wall);
}

uint32_t GrainFill::addBall(float radius, const Vector3f& place, float density, float until)
{
    Material material = builder_.world().materials[0];
    material.name = "ball";
    material.density = density;
    const uint32_t index = builder_.addMaterial(material);
    const uint32_t body = addRoundBody(builder_, {radius, 0}, {place}, {0, 0, 0}, {0, 0, 0}, index);
    builder_.holdBody(body, until);
    return body;
}

double slopeOf(const std::vector<Vector3f>& grains, float base)
{
    std::vector<std::vector<double>> tops(60);
    for (size_t r = 0; r < tops.size(); ++r)
        tops[r].assign(std::max(1, static_cast<int>(2.0 * M_PI * (static_cast<double>(r) + 0.5) / 1.6)), 0.0);
    for (const Vector3f& p : grains) {
        const auto ring = static_cast<size_t>(std::hypot(p.x(), p.z()) / DIAMETER);
        if (ring >= tops.size() || p.y() < base) continue;
        const size_t patches = tops[ring].size();
        const double turn = (std::atan2(p.z(), p.x()) + M_PI) / (2.0 * M_PI);
        double& top = tops[ring][static_cast<size_t>(turn * static_cast<double>(patches)) % patches];
        top = std::max(top, static_cast<double>(p.y() - base) + 0.5 * DIAMETER);
    }
    std::vector<double> heights;
    for (const auto& ring : tops) {
        double sum = 0.0;
        for (double top : ring) sum += top;
        heights.push_back(sum / static_cast<double>(ring.size()));
    }
    const double highest = *std::max_element(heights.begin(), heights.end());
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (size_t r = 0; r < heights.size(); ++r) {
        if (heights[r] < 0.2 * highest || heights[r] > 0.8 * highest) continue;
        const double x = (static_cast<double>(r) + 0.5) * DIAMETER;
        n += 1;
        sx += x;
        sy += heights[r];
        sxx += x * x;
        sxy += x * heights[r];
    }
    return std::atan(-(n * sxy - sx * sy) / (n * sxx - sx * sx)) * 180.0 / M_PI;
}

}  // namespace knuckle::test
