// What stackBlocks holds of each body of a stack (shared/stack_records.h).
#include "shared/stack_records.h"
#include "math/spatial.glsl"

READ_BUFFER(uint, StackOrder, stackOrder);
BUFFER(vec4, StackBlocks, stackBlocks);

mat3 loadBlock(uint t)
{
    return mat3(stackBlocks[t].xyz, stackBlocks[t + 1u].xyz, stackBlocks[t + 2u].xyz);
}

void storeBlock(uint t, mat3 m)
{
    for (uint k = 0u; k < 3u; ++k) stackBlocks[t + k].xyz = m[k];
}

Inertia loadInertia(uint body, uint record)
{
    uint t = STACK_TEXELS * body + record;
    return Inertia(loadBlock(t), loadBlock(t + 3u), loadBlock(t + 6u));
}

void storeInertia(uint body, uint record, Inertia m)
{
    uint t = STACK_TEXELS * body + record;
    storeBlock(t, m.a);
    storeBlock(t + 3u, m.b);
    storeBlock(t + 6u, m.d);
}

Force loadForce(uint body, uint record)
{
    uint t = STACK_TEXELS * body + record;
    return Force(stackBlocks[t].xyz, stackBlocks[t + 1u].xyz);
}

void storeForce(uint body, uint record, Force f)
{
    uint t = STACK_TEXELS * body + record;
    stackBlocks[t].xyz = f.t;
    stackBlocks[t + 1u].xyz = f.r;
}

Motion loadStep(uint body)
{
    Force step = loadForce(body, STACK_STEP);
    return Motion(step.t, step.r);
}

Motion loadMotion(uint body, uint record)
{
    Force m = loadForce(body, record);
    return Motion(m.t, m.r);
}

void storeMotion(uint body, uint record, Motion m)
{
    storeForce(body, record, Force(m.t, m.r));
}

Motion add(Motion x, Motion y)
{
    return Motion(x.t + y.t, x.r + y.r);
}

float product(Force f, Motion m)
{
    return dot(f.t, m.t) + dot(f.r, m.r);
}

/// Adds a force to that of a record.
void addForce(uint body, uint record, Force f)
{
    storeForce(body, record, add(loadForce(body, record), f));
}

Inertia noInertia()
{
    return Inertia(mat3(0), mat3(0), mat3(0));
}

/// A force that acts at `arm` from a point, seen from that point.
Force forceAt(vec3 arm, vec3 force)
{
    return Force(force, cross(arm, force));
}

/// A stiffness at `arm` from a point, seen from that point.
Inertia stiffnessAt(vec3 arm, mat3 stiffness)
{
    return shifted(Inertia(stiffness, mat3(0), mat3(0)), -arm);
}
