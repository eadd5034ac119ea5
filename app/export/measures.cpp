#include "app/export/measures.h"

#include <fmt/format.h>

namespace knuckle {

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

void MeasureExport::begin(const Scene& /*scene*/)
{
    file_.emplace(path());
    std::string head = "frame";
    for (const auto& [name, value] : measureFields({})) head += fmt::format(",{}", name);
    file_->write(head += '\n');
}

void MeasureExport::frame(const ExportFrame& frame)
{
    std::string row = fmt::format("{}", frame.number);
    for (const auto& [name, value] : measureFields(*frame.measures)) row += fmt::format(",{}", value.dump());
    file_->write(row += '\n');
}

}  // namespace knuckle
