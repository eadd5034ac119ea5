// Which bodies of an object never touch each other: a bit for each pair, in both directions.

uniform usamplerBuffer bodyPasses;       // per body: its first bit; the first body of its object, the last's end

/// The bit that says whether a body passes another; NONE where none does.
uint passBit(uint body, uint other)
{
    uvec4 t = texelFetch(bodyPasses, int(body));
    return other >= t.y && other < t.z ? t.x + other - t.y : NONE;
}
