// Contents of `predicted`: how far a particle moves in the substep, as far as that is known.

struct PredictedMove {
    vec3 move;                  // x* - x [m]
    float contactInverseMass;   // as contacts see it; 0: it does not respond [1/kg]
};

PredictedMove predictedMove(vec4 t)
{
    return PredictedMove(t.xyz, t.w);
}

vec4 pack(PredictedMove p)
{
    return vec4(p.move, p.contactInverseMass);
}
