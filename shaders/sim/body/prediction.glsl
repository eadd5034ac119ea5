// How far a mover would move in the substep if nothing touched it.
#include "sim/common/bodies/fields.glsl"

uniform samplerBuffer moverVelocities;
uniform samplerBuffer oldMoverVelocities;
uniform samplerBuffer oldMoverMoves;

/// Whether a substep is of second order: where nothing touched the assembly lately.
bool isSecondOrder(uint m, uint lastContact, uint now)
{
    return responds(m) && sim.secondOrder == 1u && now > 0u && lastContact + 1u != now;
}

/// First order goes on along the chord of the last turn, which is a turn by less: 1 - phi^2 of it. This much further
/// it goes on by as much: a ball that rolls would else stop.
float chordScale(mat3 chord)
{
    float size = dot(chord[0], chord[0]) + dot(chord[1], chord[1]) + dot(chord[2], chord[2]);   // 4 (1 - cos phi)
    return 1.0 / (1.0 - 0.5 * min(size, LONGEST_CHORD));
}

/// BDF2, or symplectic Euler. @param keepsTurning whether it goes on by as much as it turned, see chordScale().
Field predictedMove(uint m, bool second, bool keepsTurning)
{
    float h = sim.substepTime;
    Field v = fetchField(moverVelocities, m);
    if (!second) {
        if (keepsTurning) v.f *= chordScale(h * v.f);
        return Field(h * (v.t + h * sim.gravity.xyz), h * v.f);
    }
    Field move = fetchField(oldMoverMoves, m), last = fetchField(oldMoverVelocities, m);
    return Field(move.t / 3.0 + h * (8.0 * v.t - 2.0 * last.t + 4.0 * h * sim.gravity.xyz) / 9.0,
                 move.f / 3.0 + h * (8.0 * v.f - 2.0 * last.f) / 9.0);
}
