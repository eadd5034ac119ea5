// Which bodies of an object never touch each other: a bit for each pair, in both directions.

uniform usamplerBuffer bodyFilters;

struct BodyFilters {
    uint firstBit;             // of filterBits, a multiple of 32
    uint firstBody, endBody;   // of its object; zero if the body filters none
};

BodyFilters fetchBodyFilters(uint body)
{
    uvec4 t = texelFetch(bodyFilters, int(body));
    return BodyFilters(t.x, t.y, t.z);
}

/// The bit that says whether a body filters another; NONE if there is none.
uint passBit(uint body, uint other)
{
    BodyFilters own = fetchBodyFilters(body);
    return other >= own.firstBody && other < own.endBody ? own.firstBit + other - own.firstBody : NONE;
}
