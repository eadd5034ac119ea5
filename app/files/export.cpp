#include "app/files/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <filesystem>

#include "app/json/json.h"

namespace knuckle {

namespace {

static_assert(std::endian::native == std::endian::little, "the PLY writer copies values as they lie in memory");

template <typename T>
void append(std::string& out, const T& value)
{
    out.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

/// A CSV field: quoted where it must be.
std::string field(const std::string& text)
{
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + '"';
}

/// A line for each material: its index and name, without what would end the line.
std::string materialComments(const World& world)
{
    std::string out;
    for (size_t i = 0; i < world.materials.size(); ++i) {
        std::string name = world.materials[i].name;
        std::erase_if(name, [](unsigned char c) { return c < ' '; });
        out += fmt::format("comment material {} {}\n", i, name);
    }
    return out;
}

/// What both --stats and --export measures tell, in the order of docs/output.md.
std::vector<std::pair<std::string, Json>> measureFields(const Measures& m)
{
    return {
        {"contacts", m.contactCount},
        {"meanPenetration", m.meanPenetration},
        {"worstPenetration", m.worstPenetration},
        {"meanJointGap", m.meanJointGap},
        {"worstJointGap", m.worstJointGap},
        {"worstShapeError", m.worstShapeError},
        {"meanSoftStrain", m.meanSoftStrain},
        {"worstSoftStrain", m.worstSoftStrain},
        {"softVolumeError", m.softVolumeError},
        {"fluidParticles", m.fluidCount},
        {"fluidEmitted", m.fluidEmitted},
        {"fluidDrained", m.fluidDrained},
        {"pinForce", m.pinForce},
        {"pinTorque", m.pinTorque},
        {"pinImpulse", m.pinImpulse},
        {"pinWork", m.pinWork},
        {"caught", m.caughtCount},
        {"knockedOut", m.knockedOutCount},
        {"meanDensityError", m.meanDensityError},
        {"worstDensityError", m.worstDensityError},
        {"fluidVolumeError", m.fluidVolumeError},
        {"meanStretch", m.meanStretch},
        {"worstStretch", m.worstStretch},
        {"maxSpeed", m.maxSpeed},
        {"kineticEnergy", m.kineticEnergy},
    };
}

}  // namespace

void writePly(const std::string& folder, uint64_t frame, const World& world, const ParticleState& state)
{
    const auto there = std::count(state.inactive.begin(), state.inactive.end(), false);
    std::string text = fmt::format("ply\nformat binary_little_endian 1.0\ncomment frame {}\nelement vertex {}\n", frame,
                                   there);
    text.insert(text.find("element"), materialComments(world));
    text += "property uint id\nproperty float x\nproperty float y\nproperty float z\nproperty float vx\n"
            "property float vy\nproperty float vz\nproperty int body\nproperty uint material\nend_header\n";
    for (uint32_t i = 0; i < state.positions.size(); ++i) {
        if (state.inactive[i]) continue;
        const Particle& particle = world.particles[i];
        append(text, i);
        for (const Vector3f& vector : {state.positions[i], state.velocities[i]}) {
            for (int axis = 0; axis < 3; ++axis) append(text, vector[axis]);
        }
        append(text, static_cast<int32_t>(particle.body));  // NO_INDEX becomes -1
        append(text, particle.material);
    }
    OutputFile file((std::filesystem::path(folder) / fmt::format("frame_{:04}.ply", frame)).string());
    file.write(text);
    file.commit();
}

BodyTable::BodyTable(const std::string& path) : file_(path)
{
    file_.write("frame,body,object,name,x,y,z,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz\n");
}

void BodyTable::write(uint64_t frame, const World& world, const std::vector<BodyState>& states)
{
    std::string text;
    for (size_t i = 0; i < states.size(); ++i) {
        const BodyState& state = states[i];
        const Body& body = world.bodies[i];
        const std::string object = body.object == NO_INDEX ? "" : world.objects[body.object].name;
        text += fmt::format("{},{},{},{}", frame, i, field(object), field(body.name));
        for (const float value : state.position) text += fmt::format(",{}", value);
        for (const float value : state.rotation.coeffs()) text += fmt::format(",{}", value);
        for (const float value : state.velocity) text += fmt::format(",{}", value);
        for (const float value : state.angularVelocity) text += fmt::format(",{}", value);
        text += '\n';
    }
    file_.write(text);
}

MeasureTable::MeasureTable(const std::string& path) : file_(path)
{
    std::string head = "frame";
    for (const auto& [name, value] : measureFields({})) head += fmt::format(",{}", name);
    file_.write(head += '\n');
}

void MeasureTable::write(uint64_t frame, const Measures& measures)
{
    std::string row = fmt::format("{}", frame);
    for (const auto& [name, value] : measureFields(measures)) row += fmt::format(",{}", value.dump());
    file_.write(row += '\n');
}

std::string hashText(uint64_t hash)
{
    return fmt::format("{:016x}", hash);
}

/// null where the program has not chosen.
Json threadsJson(const DriverThreads& threads)
{
    return {{"count", threads.count ? Json(*threads.count) : Json()},
            {"drawAside", threads.drawAside},
            {"reason", threads.reason}};
}

/// null where what was let go was at rest.
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
