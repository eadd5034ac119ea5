// A corner of one triangle over the whole picture.
vec4 screenCorner()
{
    return vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
