// A plain weave: threads pass over and under each other in turn.

/// Height of the bumps over the distance of threads.
const float WEAVE_HEIGHT = 0.05;
/// How much darker it is between the bumps.
const float WEAVE_SHADE = 0.08;

struct Weave {
    vec2 slope;     // of its height, per thread
    float shade;    // factor of the colour's roots
};

/// @param threads place on the sheet. Fades from eight pixels a thread down to three.
Weave weaveAt(vec2 threads, vec2 perX, vec2 perY)
{
    float pixel = sqrt(max(dot(perX, perX), dot(perY, perY)));
    float seen = 1.0 - smoothstep(0.12, 0.3, pixel);
    vec2 angle = 3.14159265 * threads, s = sin(angle), c = cos(angle);
    float height = s.x * s.y;
    return Weave(seen * WEAVE_HEIGHT * 3.14159265 * vec2(c.x * s.y, s.x * c.y),
                 1.0 - seen * WEAVE_SHADE * (1.0 - height * height));
}
