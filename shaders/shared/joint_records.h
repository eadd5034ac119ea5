// How many texels of 16 bytes the records of joints have, for C++ and GLSL. sim/solver/joint/joint_stage.h draws them;
// the kernels of shaders/sim/joint name their fields.
#ifndef KNUCKLE_JOINT_RECORDS_H
#define KNUCKLE_JOINT_RECORDS_H

// Of each joint, loops behind those of trees.
#define JOINT_PLACE_TEXELS 4       // where it is in both bodies
#define JOINT_LOAD_TEXELS 2        // what it bore
#define JOINT_LIMIT_TEXELS 4        // where its limits stop it
// Of each joint of a tree.
#define JOINT_FACTOR_TEXELS 11     // what its body and all that hangs on it have been eliminated to
#define JOINT_INERTIA_TEXELS 6      // what of that its parent sees
#define JOINT_SWEEP_TEXELS 9       // what the sweeps over its tree leave for each other
#define ROOT_FACTOR_TEXELS 6       // where nothing holds its body: the same
// Of each joint that closes a loop.
#define LOOP_FACTOR_TEXELS 10      // how its ends move apart
// Of each body.
#define BODY_LOAD_TEXELS 4         // what acts on one that has joints
#define BODY_RESPONSE_TEXELS 9     // how it answers with what its joints move along

#endif
