// The surfaces of boxes and balls: out of them and how far it is to them from a point of their own frame [m].

vec4 boxSurface(vec3 p, vec3 halfExtents)
{
    vec3 q = abs(p) - halfExtents;
    vec3 side = vec3(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0, p.z < 0.0 ? -1.0 : 1.0);
    vec3 outside = max(q, 0.0);
    float apart = length(outside);
    float inner = max(q.x, max(q.y, q.z));
    vec3 face = q.x >= inner ? vec3(1, 0, 0) : q.y >= inner ? vec3(0, 1, 0) : vec3(0, 0, 1);
    return vec4(side * (apart > 1e-9 ? outside / apart : face), apart > 0.0 ? apart : inner);
}

vec4 ballSurface(vec3 p, float radius)
{
    float apart = length(p);
    return vec4(apart > 1e-9 ? p / apart : vec3(1, 0, 0), apart - radius);
}
