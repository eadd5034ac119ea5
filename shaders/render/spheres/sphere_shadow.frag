// A disc through the sphere's centre: its shadow is that of the sphere, and it never shades the lit side.
void main()
{
    vec2 p = 2.0 * gl_PointCoord - 1.0;
    if (dot(p, p) > 1.0) discard;
}
