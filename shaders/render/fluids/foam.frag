// Adds up foam, spray and bubbles.
flat in vec4 foam;
layout(location = 0) out vec4 covered;   // light times coverage, coverage

void main()
{
    vec2 p = 2.0 * gl_PointCoord - 1.0;
    float inner = max(1.0 - dot(p, p), 0.0);
    covered = inner * inner * foam;
}
