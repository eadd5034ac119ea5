// What a fluid particle remembers from one substep to the next.

struct FluidPast {
    vec3 position;       // where it was predicted to be at the end of the last substep [m]
    float compression;   // by how much its surroundings are denser than at rest, by their moves; JUST_EMITTED
};

#define JUST_EMITTED -1.0

FluidPast fluidPast(vec4 t)
{
    return FluidPast(t.xyz, t.w);
}

vec4 pack(FluidPast past)
{
    return vec4(past.position, past.compression);
}
