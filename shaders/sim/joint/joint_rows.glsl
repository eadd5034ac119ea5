// The rows of the channel that store the impulses of joints. MANY_PUSHES: a thread may push a row more than once.
#include "sim/joint/joint_info.glsl"
#include "math/spatial.glsl"

uniform samplerBuffer lastRowImpulses;
BUFFER(vec4, RowImpulses, newRowImpulses);
#ifdef ANGULAR
uniform samplerBuffer lastRowAngularImpulses;
BUFFER(vec4, RowAngularImpulses, newRowAngularImpulses);
#endif

// If each row is pushed once, its old value is read from a texture, which llvmpipe does three times as fast.
#ifdef MANY_PUSHES
#define ROW(name, row) new##name[row].xyz
#else
#define ROW(name, row) texelFetch(last##name, int(row)).xyz
#endif

void push(uint row, Force f)
{
    if (row == NONE) return;
    newRowImpulses[row].xyz = ROW(RowImpulses, row) + f.t;
#ifdef ANGULAR
    newRowAngularImpulses[row].xyz = ROW(RowAngularImpulses, row) + f.r;
#endif
}

void clearRow(uint row)
{
    if (row == NONE) return;
    newRowImpulses[row] = vec4(0);
#ifdef ANGULAR
    newRowAngularImpulses[row] = vec4(0);
#endif
}

/// Clears the rows of a joint that holds nothing any more.
void clearRows(Joint joint)
{
    clearRow(joint.row);
    clearRow(joint.parentRow);
}

/// @param held on the body; its parent gets the opposite.
void pushBoth(uint k, Force held)
{
    Joint joint = fetchJoint(k);
    push(joint.row, held);
    push(joint.parentRow, Force(-held.t, -held.r));
}
