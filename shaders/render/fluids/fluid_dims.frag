// Adds up what the key light loses on its way through fluid.
flat in vec4 dims;
layout(location = 0) out vec4 dimmed;   // optical depths of red, green, blue, and the way through fluid [m]

void main()
{
    vec2 p = 2.0 * gl_PointCoord - 1.0;
    float inner = max(1.0 - dot(p, p), 0.0);
    dimmed = inner * inner * dims;
}
