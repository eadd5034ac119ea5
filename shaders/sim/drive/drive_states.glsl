// Changing state of drives and pins, in texels of driveStates and pinStates. Differences are from the clip's place.
#include "shared/drive_types.h"

#define DRIVE_TURN 0u      // the difference, when the substep began
#define DRIVE_TARGET 1u    // the clip at its end
#define DRIVE_CHANGE 2u    // of the difference in the substep before [rad]; w: part of its torque that the limit leaves
#define DRIVE_HELD 3u      // x: time since which that part has been below 1 [s]

#define PIN_TURN 0u        // the same for a pin's turn ...
#define PIN_TARGET_TURN 1u
#define PIN_TURNED 2u
#define PIN_WAY 3u         // ... and for its place [m]
#define PIN_TARGET_PLACE 4u
#define PIN_MOVED 5u

// Of pinsGiven.
#define GIVEN_FORCE 0u     // [N]
#define GIVEN_TORQUE 1u    // [N m]
#define GIVEN_SUM 2u       // since the start: impulse [N s]; w: work [J]
