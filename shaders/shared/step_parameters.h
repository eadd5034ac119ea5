// Data of the world for all kernels of the simulation. As in gpu_types.h, members are four-byte scalars and
// sixteen-byte vectors; tests/solver/layout_test.cpp lists them once more.
#ifndef KNUCKLE_STEP_PARAMETERS_H
#define KNUCKLE_STEP_PARAMETERS_H

#include "shared/gpu_types.h"

#ifdef __cplusplus
namespace knuckle::gpu {
#endif

// Uploaded once. Each stage of the solver sets its own.
struct StepParameters {
    // The world.
    vec4 gravity;                   // xyz [m/s2]
    vec4 wind;                      // xyz its mean velocity [m/s], w the density of the air [kg/m3]
    uint particleCount;             // solid particles
    uint fluidCount;                // fluid particles, which come after them
    uint bodyCount;
    uint moverCount;                // bodies and loose particles
    uint freeBodyCount;             // bodies that may respond and have no joints
    uint jointedBodyCount;          // and those with joints
    uint releaseCount;              // bodies that are held or animated and may be let go
    uint impulseWatchCount;         // pairs of bodies and releases: by an impulse, ...
    uint touchWatchCount;           // ... by touch, ...
    uint regionWatchCount;          // ... by region
    uint animatedCount;             // bodies that clips move
    uint puppetCount;               // animated objects that are driven
    uint jointDriveCount;           // their driven joints
    uint pinCount;                  // and their pins
    uint motorCount;                // motors and springs of joints
    uint gearTrainCount;            // sets of gears that share hinges
    uint linkCount;
    uint assemblyCount;
    uint colliderCount;
    uint movingColliderCount;       // those that clips move
    float diameter;                 // [m]
    // Time, and values for all movers.
    uint substeps;                  // a step
    float substepTime;              // [s]
    uint secondOrder;               // 1: BDF2 if nothing touches
    float damping;                  // velocity kept per substep
    float maxSpeed;                 // [m/s]
    float virtualParticles;         // c of eq. 18
    uint rotationIterations;
    float massScaling;              // k of m exp(-k height) [1/m]
    // Wind and force fields.
    uint forceFieldCount;
    uint gustWaveCount;
    float dropDrag;                 // half of drag coefficient times area of a fluid particle as a drop [m2]
    // The search for contacts.
    float contactReach;            // candidates are nearer than this [m]
    float plainReach;              // the same if neither belongs to a ball or capsule [m]
    float inverseCellSize;          // [1/m]
    uint cellMask;                  // cells - 1, cells a power of two
    uint cellStrideY;               // lattice grid: cells between neighbours in y ...
    uint cellStrideZ;               // ... and in z
    uint candidateCapacity;         // contacts of all kinds as they are found
    uint pairCapacity;              // contacts between particles
    uint colliderPairCapacity;      // contacts with colliders
    float drift;                    // a particle that has moved further makes a new search due [m]
    float lookAhead;                // of found positions, in moves of a substep
    float horizon;                  // how long contacts should stay valid, in substeps
    float farReach;                 // most by which fast movers may look further for contacts [m]
    uint fastLimit;                 // most particles that may do so
    // Contacts and their restitution.
    float correction;               // fraction of a penetration that one substep corrects
    float maxCorrection;            // of a penetration per substep, with speed [m]
    float warmStart;                // fraction of a normal impulse that an iteration keeps
    float impulseDamping;                  // fraction of an impulse's difference from its mean that an iteration
                                           // removes
    float meanRate;                 // fraction of the way to the impulse that its mean moves in an iteration
    float restitutionThreshold;     // slower collisions do not bounce [m/s]
    // Joints.
    uint sharedCount;               // particles of two or more bodies
    uint jointTreeCount;
    uint treeJointCount;            // joints of trees; those that close loops come after them
    // Sleep.
    float sleepSpeed;               // assemblies that are slower for long sleep [m/s]
    float freeze;                   // assemblies that stay within this are calm [m], 0 off
    uint calmSteps;                 // calm steps before sleep
    // Soft bodies.
    uint clusterCount;
    uint softCount;                 // particles of soft bodies
    // Fluids.
    float fluidSpacing;             // rest distance [m]
    float fluidReach;               // of the smoothing kernel [m]
    float fluidListReach;           // neighbours are listed up to here [m]
    float fluidVolume;              // of a particle, over the volume that the kernel is normalized to [1/m3]
    float fluidSoftness;            // epsilon of Macklin and Mueller 2013, eq. 11 [1/m2]
    float evenSmoothing;            // part of what differs from an even change of velocity that a step takes
    float quietSpeed;               // what differs by more is flow, and keeps most of it [m/s]
    float vorticity;                // strength of vorticity confinement times the step [s]
    uint fluidSlots;                // neighbours that one particle can have in fluids, a multiple of 4
    float inverseFluidCell;         // [1/m]
    uint fluidCellMask;             // as for the other grid
    uint fluidStrideY;
    uint fluidStrideZ;
    uint foamCapacity;              // points of foam, spray and bubbles
    // Emitters and drains.
    uint fluidFilled;               // fluid particles that belong to no emitter; they come first
    uint poolCapacity;              // entries in the lists of all emitters' pools
    uint drainCount;
    // The paper's solver.
    float overRelaxation;           // of contacts of bodies
    float stabilization;            // correction of an overlap by stabilization [m]
    float deepOverlap;              // deeper overlaps carry nothing [m]
    float deepRecovery;             // correction of a deep overlap [m]
    float jointCorrection;          // part of a joint's gap that draws a body, at most [m]
};

#ifdef __cplusplus
}  // namespace knuckle::gpu
#endif
#endif
