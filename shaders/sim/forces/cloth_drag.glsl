// The air's force on cloth: pressure across each triangle, friction along it.

uniform usamplerBuffer clothRanges;      // per loose mover: its first triangle, and how many
uniform usamplerBuffer clothTriangles;   // particles of a triangle's corners, once for each corner
uniform samplerBuffer positions;         // when the step began

/// Drag of one node of cloth, for its third of each triangle. @param wind past it [m/s].
vec3 clothDrag(uint m, vec3 wind)
{
    uvec2 range = texelFetch(clothRanges, int(m - sim.bodyCount)).xy;
    float perArea = 0.5 * sim.wind.w * fetchMover(m).inverseMass;
    vec3 acceleration = vec3(0);
    for (uint t = range.x; t < range.x + range.y; ++t) {
        uvec3 corners = texelFetch(clothTriangles, int(t)).xyz;
        vec3 a = texelFetch(positions, int(corners.x)).xyz;
        vec3 b = texelFetch(positions, int(corners.y)).xyz, c = texelFetch(positions, int(corners.z)).xyz;
        vec3 across = cross(b - a, c - a);
        float area = 0.5 * length(across);
        vec3 normal = area > 0.0 ? across / (2.0 * area) : vec3(0);
        vec3 head = dot(wind, normal) * normal, along = wind - head;
        float drag = perArea * area / 3.0;
        acceleration += dragAcceleration(head, vec3(PLATE_DRAG * drag));
        acceleration += dragAcceleration(along, vec3(SKIN_DRAG * drag));
    }
    return acceleration;
}
