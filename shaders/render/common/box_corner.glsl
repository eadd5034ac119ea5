// A corner, each side -1 or 1, of the BOX_STRIP vertices of a strip of triangles around a cube: one bit per axis and
// vertex.
vec3 boxCorner(int vertex)
{
    return vec3(uvec3(0x287au, 0x02afu, 0x31e3u) >> vertex & 1u) * 2.0 - 1.0;
}
