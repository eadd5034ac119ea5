// Which bodies of an object never touch each other: a bit for each pair, in both directions.

uniform usamplerBuffer bodyPasses;

struct BodyPasses {
    uint firstBit;             // of passBits, a multiple of 32
    uint firstBody, endBody;   // of its object; none where the body passes none
};

BodyPasses fetchBodyPasses(uint body)
{
    uvec4 t = texelFetch(bodyPasses, int(body));
    return BodyPasses(t.x, t.y, t.z);
}

/// The bit that says whether a body passes another; NONE where none does.
uint passBit(uint body, uint other)
{
    BodyPasses own = fetchBodyPasses(body);
    return other >= own.firstBody && other < own.endBody ? own.firstBit + other - own.firstBody : NONE;
}
