#include "sim/world/settings.h"

namespace knuckle {

Settings paperSettings()
{
    Settings s;
    s.solver = SolverKind::Paper;
    s.rotation = RotationMethod::Householder;
    s.grid = GridKind::Hash;
    s.reduction = ReductionKind::Steps;
    s.velocityOrder = VelocityOrder::First;
    s.substeps = 1;
    s.iterations = 4;
    s.stabilization = 1;
    s.contactMargin = 0.2f;
    s.freeze = 0.5f;
    s.virtualParticles = 0.01f;
    s.splitSharedMass = false;
    return s;
}

}  // namespace knuckle
