#include "app/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <filesystem>

#include "app/json.h"

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

}  // namespace

void writePly(const std::string& folder, uint64_t frame, const World& world, const ParticleState& state)
{
    const auto there = std::count(state.parked.begin(), state.parked.end(), false);
    std::string text = fmt::format("ply\nformat binary_little_endian 1.0\ncomment frame {}\nelement vertex {}\n", frame,
                                   there);
    text.insert(text.find("element"), materialComments(world));
    text += "property uint id\nproperty float x\nproperty float y\nproperty float z\nproperty float vx\n"
            "property float vy\nproperty float vz\nproperty int body\nproperty uint material\nend_header\n";
    for (uint32_t i = 0; i < state.positions.size(); ++i) {
        if (state.parked[i]) continue;
        const Particle& particle = world.particles[i];
        append(text, i);
        for (const Vector3f& vector : {state.positions[i], state.velocities[i]}) {
            for (int axis = 0; axis < 3; ++axis) append(text, vector[axis]);
        }
        append(text, static_cast<int32_t>(particle.body));    // NO_INDEX becomes -1
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

std::string hashText(uint64_t hash)
{
    return fmt::format("{:016x}", hash);
}

std::string statsText(const RunFigures& figures, const World& world, Solver& solver, const KernelTimer* drawing)
{
    const Measures measures = solver.measure();
    Json passes = Json::array(), drawingPasses = Json::array();
    const auto add = [](Json& list, const std::string& name, double milliseconds, uint64_t count) {
        list.push_back({{"name", name}, {"milliseconds", milliseconds}, {"count", count}});
    };
    for (const PassTime& pass : solver.passTimes()) add(passes, pass.name, pass.milliseconds, pass.count);
    if (drawing != nullptr) {
        for (const auto& [name, total] : drawing->totals()) add(drawingPasses, name, total.milliseconds, total.count);
    }
    const Json stats = {
        {"device", figures.device},
        {"particles", world.solidCount() + measures.fluidCount},
        {"bodies", world.bodies.size()},
        {"joints", world.joints.size()},
        {"softBodies", world.softBodies.size()},
        {"clusters", world.clusters.size()},
        {"frames", figures.frames},
        {"drawnFrames", figures.drawnFrames},
        {"steps", figures.steps},
        {"timeStep", world.settings.timeStep},
        {"substeps", world.settings.substeps},
        {"iterations", world.settings.iterations},
        {"simulationSeconds", figures.simulationSeconds},
        {"drawingSeconds", figures.drawingSeconds},
        {"totalSeconds", figures.totalSeconds},
        {"contacts", measures.contactCount},
        {"meanPenetration", measures.meanPenetration},
        {"worstPenetration", measures.worstPenetration},
        {"meanJointGap", measures.meanJointGap},
        {"worstJointGap", measures.worstJointGap},
        {"worstShapeError", measures.worstShapeError},
        {"meanSoftStrain", measures.meanSoftStrain},
        {"worstSoftStrain", measures.worstSoftStrain},
        {"softVolumeError", measures.softVolumeError},
        {"fluidParticles", measures.fluidCount},
        {"fluidEmitted", measures.fluidEmitted},
        {"fluidDrained", measures.fluidDrained},
        {"meanDensityError", measures.meanDensityError},
        {"worstDensityError", measures.worstDensityError},
        {"fluidVolumeError", measures.fluidVolumeError},
        {"meanStretch", measures.meanStretch},
        {"worstStretch", measures.worstStretch},
        {"maxSpeed", measures.maxSpeed},
        {"kineticEnergy", measures.kineticEnergy},
        {"stateHash", hashText(solver.stateHash())},
        {"passes", passes},
        {"drawingPasses", drawingPasses},
    };
    return stats.dump(2) + "\n";
}

}  // namespace knuckle
