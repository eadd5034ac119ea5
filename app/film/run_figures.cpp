#include "app/film/run_figures.h"

#include "app/export/measures.h"
#include "sim/base/fnv_hash.h"

namespace knuckle {

namespace {

/// null if the program has not chosen.
Json threadsJson(const DriverThreads& threads)
{
    return {{"count", threads.count ? Json(*threads.count) : Json()},
            {"drawAside", threads.drawAside},
            {"reason", threads.reason}};
}

/// null if everything that was let go was at rest.
Json shareOf(double part, double whole)
{
    return whole > 0.0 ? Json(part / whole) : Json();
}

Json releasesJson(const std::vector<ReleaseFigures>& releases, const World& world)
{
    Json list = Json::array();
    for (const ReleaseFigures& r : releases)
        list.push_back({{"object", world.objects[r.object].name},
                        {"time", r.time},
                        {"bodies", r.bodies},
                        {"momentumChange", shareOf(r.momentumChange, r.momentum)},
                        {"worstBodyChange", shareOf(r.worstBodyChange, r.fastest)},
                        {"worstGap", r.worstGap / world.diameter()}});
    return list;
}

}  // namespace

std::string statsText(const RunFigures& figures, const World& world, Solver& solver)
{
    const Measures measures = solver.measure();
    Json passes = Json::array(), drawingPasses = Json::array();
    const auto add = [](Json& list, const std::string& name, double milliseconds, uint64_t count) {
        list.push_back({{"name", name}, {"milliseconds", milliseconds}, {"count", count}});
    };
    for (const PassTime& pass : solver.passTimes()) add(passes, pass.name, pass.milliseconds, pass.count);
    for (const auto& [name, total] : figures.drawing.passes) add(drawingPasses, name, total.milliseconds, total.count);
    Json stats = {
        {"device", figures.device},
        {"driverThreads", threadsJson(figures.driverThreads)},
        {"particles", world.solidCount() + measures.fluidCount},
        {"bodies", world.bodies.size()},
        {"joints", jointCount(world)},
        {"softBodies", world.softBodies.size()},
        {"clusters", world.clusters.size()},
        {"frames", figures.frames},
        {"drawnFrames", figures.drawing.frames},
        {"steps", figures.steps},
        {"timeStep", world.settings.timeStep},
        {"substeps", world.settings.substeps},
        {"iterations", world.settings.iterations},
        {"searches", solver.searchCount()},
        {"start",
         {{"deviceSeconds", figures.start.device},
          {"worldSeconds", figures.start.world},
          {"kernelSeconds", figures.start.kernels},
          {"firstPictureSeconds", figures.drawing.firstSeconds}}},
        {"simulationSeconds", figures.simulationSeconds},
        {"drawingSeconds", figures.drawing.seconds},
        {"totalSeconds", figures.totalSeconds},
    };
    for (const auto& [name, value] : measureFields(measures)) stats[name] = value;
    stats["stateHash"] = hashText(solver.stateHash());
    stats["releases"] = releasesJson(figures.releases, world);
    stats["passes"] = passes;
    stats["drawingPasses"] = drawingPasses;
    return stats.dump(2) + "\n";
}

}  // namespace knuckle
