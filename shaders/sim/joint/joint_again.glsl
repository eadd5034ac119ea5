// Decides whether a tree of joints has to be eliminated again within a substep.
#include "sim/joint/joint_damping.glsl"
#include "sim/joint/joint_sweep_records.glsl"

uniform samplerBuffer treeTurns;

/// Whether the last solve turned a body of a tree so far that the next would not converge (with a load of 10,000 : 1 it
/// diverges): then Newton's method has to be linearized anew.
bool hasTurned(uint tree)
{
    const float MOST_TURN = 0.005;   // [rad]
    return texelFetch(treeTurns, int(tree)).x > MOST_TURN * MOST_TURN;
}
