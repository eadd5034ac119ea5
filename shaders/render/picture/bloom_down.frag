// A picture of half the size: each texel is the mean of four by four.
uniform sampler2D SOURCE;
layout(location = 0) out vec4 narrower;

void main()
{
    vec2 texel = 1.0 / vec2(textureSize(SOURCE, 0)), at = 2.0 * gl_FragCoord.xy * texel;
    narrower = 0.25 * (textureLod(SOURCE, at + texel * vec2(-1, -1), 0.0) +
                       textureLod(SOURCE, at + texel * vec2(1, -1), 0.0) +
                       textureLod(SOURCE, at + texel * vec2(-1, 1), 0.0) +
                       textureLod(SOURCE, at + texel * vec2(1, 1), 0.0));
}
