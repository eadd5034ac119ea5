// Smooth noise of 0 to 1 from hashed lattice points.

uint hashed(uvec3 cell)
{
    uint h = cell.x * 0x8da6b343u ^ cell.y * 0xd8163841u ^ cell.z * 0xcb1ab31fu;
    h = (h ^ h >> 15) * 0x2c1b3c6du;
    h = (h ^ h >> 12) * 0x297a2d39u;
    return h ^ h >> 15;
}

float latticeValue(ivec3 cell)
{
    return float(hashed(uvec3(cell)) >> 8) * (1.0 / 16777216.0);
}

float valueNoise(vec3 place)
{
    ivec3 low = ivec3(floor(place));
    vec3 part = place - floor(place), way = part * part * (3.0 - 2.0 * part);
    vec4 near, far;   // of both sides in x
    for (int k = 0; k < 4; ++k) {
        ivec3 cell = low + ivec3(0, k & 1, k >> 1);
        near[k] = latticeValue(cell);
        far[k] = latticeValue(cell + ivec3(1, 0, 0));
    }
    vec4 alongX = mix(near, far, way.x);
    return mix(mix(alongX.x, alongX.y, way.y), mix(alongX.z, alongX.w, way.y), way.z);
}
