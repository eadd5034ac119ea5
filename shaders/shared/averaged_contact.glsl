// One contact of the count-averaged Jacobi.

/// How far a contact has to be pushed apart in this substep [m], <= 0. Of an overlap that was there at its start only a
/// share is taken back, at a bounded speed, so that it turns into next to no velocity (the paper takes back all).
float contactError(float gap, float startGap)
{
    float old = max(-startGap, 0.0);
    return min(gap + old - min(step.correction * old, step.maxCorrection), 0.0);
}

/// The displacement of this particle for an overlap (eqs. 5-7) and friction (Macklin et al. 2014, eq. 24).
/// @param share its inverse mass over both sides' sum. @param slide relative displacement in the substep [m].
vec3 averagedContact(vec3 normal, float error, float share, vec3 slide, vec2 friction)
{
    vec3 push = -share * error * normal;
    vec3 tangent = slide - normal * dot(normal, slide);
    float size = length(tangent);
    float hold = size < friction.x * -error ? 1.0 : min(friction.y * -error / max(size, 1e-20), 1.0);
    return push - share * hold * tangent;
}
