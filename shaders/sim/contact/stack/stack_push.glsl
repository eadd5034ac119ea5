// How a contact of a stack pushes: a spring, so stiff that nothing gives visibly, and one-sided, with friction.
#include "shared/contact_constants.h"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/contacts/impulses.glsl"

// Stiffness of all contacts of a cube's face, in masses of the cube.
#define STACK_STIFFNESS 270.0

/// Stiffness of a contact by one of its sides [kg].
float stiffnessOf(Mover mover)
{
    return STACK_STIFFNESS / (mover.inverseMass * pow(float(mover.rankCount), 2.0 / 3.0));
}

// A contact remembers no more than what presses its spring by this speed in a substep: a blow would come back [m/s].
#define MOST_PRESSED 0.01
// A contact that is further apart cannot close in what a stack may move in a substep [diameters].
#define FAR_APART 0.1

struct Push {
    vec3 impulse;        // on the first side [kg m]
    float normal;        // its normal part
    float along;         // how far the sides have come apart [m]
    mat3 stiffness;      // by which it falls where the first side moves [kg]
};

/// What a spring may remember; nothing of a contact that did not push.
Impulse bounded(Impulse last, float k)
{
    if (last.normal <= 0.0) return Impulse(vec3(0), 0.0);
    float part = min(1.0, MOST_PRESSED * sim.substepTime * k / last.normal);
    return Impulse(part * last.whole, part * last.normal);
}

/// The impulse of the last substep stands for the depth then, without its rounding; what it was wrong by fades, as
/// overlap does. @param slide of the first side since the start of the substep [m]. @param k stiffness [kg].
/// FIRST: all that touch pull as well, and stick, so that it does not matter where the prediction has the bodies.
Push pushOf(vec3 normal, float startGap, vec3 slide, vec2 friction, float k, Impulse last)
{
    last = bounded(last, k);
    float along = dot(slide, normal);
    float gap = max(startGap, 0.0), fading = last.normal > 0.0 ? sim.correction : 1.0;
    float kept = (1.0 - fading) * last.normal - k * fading * gap;
    float still = kept + k * min(sim.correction * max(-startGap, 0.0), sim.maxCorrection);
    float pressed = still - k * along;
#ifdef FIRST
    bool holds = last.normal > 0.0 || startGap < TOUCHING * sim.diameter;
#else
    bool holds = false;
#endif
    if (!holds && pressed <= 0.0) return Push(vec3(0), 0.0, along, mat3(0));
    vec3 tangent = last.whole - k * slide;
    tangent -= normal * dot(normal, tangent);
    float size = length(tangent), grip = 1.0;
    bool slides = length(slide - along * normal) > STICK_SPEED * sim.substepTime;
    if (!holds && size > friction.x * pressed) grip = (slides ? friction.y : friction.x) * pressed / size;
    grip = min(grip, 1.0);
    mat3 across = outerProduct(normal, normal);
    return Push(pressed * normal + grip * tangent, pressed, along, k * (across + grip * (mat3(1) - across)));
}

/// What the contact keeps for the next substep.
Impulse keptOf(Push push, float k, float startGap)
{
    if (push.normal > 0.0) return bounded(Impulse(push.impulse, push.normal), k);
    bool soon = 2.0 * push.along < -startGap;   // as in solveContact()
    return Impulse(vec3(0), soon ? ABOUT_TO_ACT : 0.0);
}
