#include "render/surfaces/surface_arrays.h"

#include <algorithm>
#include <bit>
#include <map>
#include <utility>

#include "render/color_word.h"
#include "render/unseen.h"
#include "sim/solver/strand/strand_order.h"

namespace knuckle {

namespace {

/// Steps of a grid's surface to the side of a cell: more cells need fewer.
uint32_t stepsOf(const ClothSurface& sheet)
{
    constexpr size_t MANY = 3000, VERY_MANY = 40000;  // nodes
    return sheet.nodes.size() > VERY_MANY ? 1 : sheet.nodes.size() > MANY ? 2 : 3;
}

float asNumber(uint32_t color)
{
    return static_cast<float>(color & COLOR_BITS);
}

/// Of a sheet's first loose particle: held ones are of bodies, which may have other colours.
float colorOf(const World& world, const ClothSurface& sheet, const std::vector<uint32_t>& colors)
{
    const auto loose = [&](uint32_t node) { return world.particles[node].body == NO_INDEX; };
    const auto found = std::ranges::find_if(sheet.nodes, loose);
    return asNumber(colors[found == sheet.nodes.end() ? sheet.nodes.front() : *found]);
}

/// The threads of cloth between pairs of particles that may tear, in the solver's order.
std::map<std::pair<uint32_t, uint32_t>, uint32_t> tearableThreads(const World& world)
{
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> threads;
    if (!canTear(world)) return threads;
    const StrandOrder order = strandOrder(world);
    for (size_t s = 0; s < world.strands.size(); ++s) {
        const Strand& strand = world.strands[s];
        if (strand.kind != DistanceKind::Stretch) continue;
        for (size_t k = 0; k < strand.restLengths.size(); ++k)
            threads[std::minmax(strand.particles[k], strand.particles[k + 1])] = static_cast<uint32_t>(
                order.stateOf(world, s, k));
    }
    return threads;
}

}  // namespace

SurfaceArrays::SurfaceArrays(const World& world, const std::vector<uint32_t>& colors)
{
    const std::vector<uint32_t> unseen = unseenBits(world);
    for (const ClothSurface& sheet : world.drawn.cloth) {
        if (sheet.nodes.empty() || hasBit(unseen, sheet.nodes.front())) continue;
        if (sheet.rows > 0) addGrid(sheet, stepsOf(sheet), colorOf(world, sheet, colors));
        else addMesh(sheet, colorOf(world, sheet, colors));
    }
    addCells(world);
    hemEdges = borderEdges(triangles);
    std::map<const SoftHull*, uint32_t> hulls;
    for (const SoftSurface& surface : world.drawn.soft) {
        const SoftBody& body = world.softBodies[surface.softBody];
        if (hasBit(unseen, body.particleStart)) continue;
        const auto [hull, isNew] = hulls.emplace(surface.hull.get(), softLinks.size() / SOFT_LINKS);
        for (const HullVertex& vertex : surface.hull->vertices)
            for (size_t k = 0; isNew && k < HULL_LINKS; ++k)
                softLinks.push_back({vertex.particles[k], std::bit_cast<uint32_t>(vertex.weights[k])});
        addSoft(world, surface, hull->second, asNumber(colors[body.particleStart]));
    }
}

void SurfaceArrays::addGrid(const ClothSurface& sheet, uint32_t steps, float color)
{
    const auto firstVertex = static_cast<uint32_t>(looks.size());
    const auto index = static_cast<uint32_t>(sheets.size());
    const uint32_t across = (sheet.columns - 1) * steps, along = (sheet.rows - 1) * steps;
    const auto firstCell = static_cast<uint32_t>(cellCorners_.size());
    sheets.push_back({static_cast<uint32_t>(clothNodes.size()), sheet.columns, sheet.rows, firstCell, steps, 0, 0, 0});
    clothNodes.insert(clothNodes.end(), sheet.nodes.begin(), sheet.nodes.end());
    const auto threads = [&](uint32_t place) {
        return THREADS_A_CELL * static_cast<float>(place) / static_cast<float>(steps);
    };
    for (uint32_t j = 0; j <= along; ++j)
        for (uint32_t k = 0; k <= across; ++k) {
            clothVertices.push_back({index, k, j, 0});
            looks.push_back({threads(k), threads(j), CLOTH_HALF, color});
            particles.push_back(sheet.nodes[(j + steps / 2) / steps * sheet.columns + (k + steps / 2) / steps]);
        }
    for (uint32_t j = 0; j < along; ++j)
        for (uint32_t k = 0; k < across; ++k) {
            const uint32_t corner = firstVertex + j * (across + 1) + k, below = corner + across + 1;
            triangles.push_back({corner, below, corner + 1});
            triangles.push_back({corner + 1, below, below + 1});
            const uint32_t cell = firstCell + j / steps * (sheet.columns - 1) + k / steps;
            cells.insert(cells.end(), 2, cell);
        }
    for (uint32_t j = 0; j + 1 < sheet.rows; ++j)
        for (uint32_t k = 0; k + 1 < sheet.columns; ++k) {
            const uint32_t node = j * sheet.columns + k, below = node + sheet.columns;
            cellCorners_.push_back(
                {sheet.nodes[node], sheet.nodes[node + 1], sheet.nodes[below + 1], sheet.nodes[below]});
        }
}

void SurfaceArrays::addMesh(const ClothSurface& sheet, float color)
{
    const auto firstVertex = static_cast<uint32_t>(looks.size());
    const auto index = static_cast<uint32_t>(sheets.size());
    sheets.push_back({static_cast<uint32_t>(clothNodes.size()), 0, 0, 0, 1, 0, 0, 0});
    clothNodes.insert(clothNodes.end(), sheet.nodes.begin(), sheet.nodes.end());
    particles.insert(particles.end(), sheet.nodes.begin(), sheet.nodes.end());
    for (uint32_t node = 0; node < sheet.nodes.size(); ++node) {
        clothVertices.push_back({index, node, 0, 0});
        looks.push_back({-1.0f, 0.0f, CLOTH_HALF, color});
    }
    for (const auto& [a, b, c] : sheet.triangles) {
        triangles.push_back({firstVertex + a, firstVertex + b, firstVertex + c});
        cells.push_back(static_cast<uint32_t>(cellCorners_.size()));
        cellCorners_.push_back({sheet.nodes[a], sheet.nodes[b], sheet.nodes[c]});
    }
}

void SurfaceArrays::addCells(const World& world)
{
    const auto threads = tearableThreads(world);
    for (const std::vector<uint32_t>& corners : cellCorners_) {
        std::vector<uint32_t> sides(4, NEVER_TORN);
        for (size_t k = 0; k < corners.size(); ++k) {
            const auto thread = threads.find(std::minmax(corners[k], corners[(k + 1) % corners.size()]));
            if (thread != threads.end()) sides[k] = thread->second;
        }
        clothCells.push_back({sides[0], sides[1], sides[2], sides[3]});
    }
}

void SurfaceArrays::addSoft(const World& world, const SoftSurface& surface, uint32_t firstHullVertex, float color)
{
    const auto firstVertex = static_cast<uint32_t>(looks.size());
    const uint32_t firstParticle = world.softBodies[surface.softBody].particleStart;
    for (uint32_t v = 0; v < surface.hull->vertices.size(); ++v) {
        softVertices.push_back({firstHullVertex + v, firstParticle});
        looks.push_back({-1.0f, 0.0f, 0.0f, color});
        particles.push_back(firstParticle + surface.hull->vertices[v].particles[0]);
    }
    for (const auto& [a, b, c] : surface.hull->triangles)
        triangles.push_back({firstVertex + a, firstVertex + b, firstVertex + c});
}

}  // namespace knuckle
