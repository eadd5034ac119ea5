// A picture of twice the size, softened by a tent of three by three texels.
uniform sampler2D SOURCE;
layout(location = 0) out vec4 wider;

void main()
{
    vec2 texel = 1.0 / vec2(textureSize(SOURCE, 0)), at = 0.5 * gl_FragCoord.xy * texel;
    vec4 sum = vec4(0.0);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            sum += float((2 - abs(x)) * (2 - abs(y))) * textureLod(SOURCE, at + texel * vec2(x, y), 0.0);
    wider = sum / 16.0;
}
