// Sizes of joints' records in texels of 16 bytes, for C++ and GLSL. sim/solver/joint/joint_stage.h draws them; the
// kernels of shaders/sim/joint name their fields.
#ifndef KNUCKLE_JOINT_RECORDS_H
#define KNUCKLE_JOINT_RECORDS_H

// Of each joint, loops after those of trees.
#define JOINT_PLACE_TEXELS 4       // where it is in both bodies
#define JOINT_LOAD_TEXELS 2        // its load
#define JOINT_LIMIT_TEXELS 4        // where its limits stop it
// Of each joint of a tree.
#define JOINT_FACTOR_TEXELS 11     // its body with all that hangs on it, eliminated
#define JOINT_INERTIA_TEXELS 6      // the part of that which its parent sees
#define JOINT_SWEEP_TEXELS 9       // values that the sweeps over its tree pass to each other
#define ROOT_FACTOR_TEXELS 6       // the same for a body that nothing holds
// Of each joint that closes a loop.
#define LOOP_FACTOR_TEXELS 10      // how its ends move apart
#define LOOP_SEARCH_TEXELS 8       // where the search for its force is
// Of each geared hinge.
#define GEAR_STATE_TEXELS 2        // how far it is off its train, its torque; sums over its train
// Of each body.
#define BODY_LOAD_TEXELS 4         // what acts on a body with joints
#define BODY_RESPONSE_TEXELS 9     // its motion for a force, with what its joints move along

// Rounds in which an iteration looks for the forces of a tree's loops, at most.
#define MOST_LOOP_ROUNDS 64u

#endif
