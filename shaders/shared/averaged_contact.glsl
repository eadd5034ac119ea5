// One contact of the paper's count-averaged Jacobi.

/// The displacement of this particle for an overlap (eqs. 5-7) and friction (Macklin et al. 2014, eq. 24).
/// @param share its inverse mass over both sides' sum. @param slide relative displacement in the substep [m].
vec3 averagedContact(vec3 normal, float gap, float share, vec3 slide, vec2 friction)
{
    vec3 push = -share * gap * normal;
    vec3 tangent = slide - normal * dot(normal, slide);
    float size = length(tangent);
    float hold = size < friction.x * -gap ? 1.0 : min(friction.y * -gap / max(size, 1e-20), 1.0);
    return push - share * hold * tangent;
}
