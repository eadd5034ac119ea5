// Adds up what light loses on its way through fluid, and what comes back from there.
flat in vec4 tint, glow;
#ifdef EMISSION
flat in vec4 emission;
layout(location = 2) out vec4 emissions;   // the colour sent out times the optical depth, which is the last
#endif
layout(location = 0) out vec4 tints;   // optical depths of red, green, blue, and of what is scattered
layout(location = 1) out vec4 glows;   // the colour that comes back times the last, and the way through fluid [m]

void main()
{
    vec2 p = 2.0 * gl_PointCoord - 1.0;
    float inner = 1.0 - dot(p, p);
    if (inner < 0.0) discard;
    tints = inner * inner * tint;
    glows = inner * inner * glow;
#ifdef EMISSION
    emissions = inner * inner * emission;
#endif
}
