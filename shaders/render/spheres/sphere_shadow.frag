// A disc through the sphere's centre: its shadow is the sphere's own, and it never shades the side in the light.
void main()
{
    vec2 p = 2.0 * gl_PointCoord - 1.0;
    if (dot(p, p) > 1.0) discard;
}
