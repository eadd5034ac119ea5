// A draft at the size of the frame: by Catmull and Rom's curve along both axes, in five taps (J. Jimenez, "Filmic
// SMAA", 2016), within the range of its neighbours so that edges have no rims.
uniform sampler2D smoothedPicture;
layout(location = 0) out vec4 enlarged;
#ifdef TRANSPARENT
uniform sampler2D smoothedCoverPicture;
#endif

void main()
{
    vec2 size = vec2(textureSize(smoothedPicture, 0)), at = 0.5 * gl_FragCoord.xy;
    vec2 middle = floor(at - 0.5) + 0.5, f = at - middle;
    vec2 w0 = f * (-0.5 + f * (1.0 - 0.5 * f)), w1 = 1.0 + f * f * (-2.5 + 1.5 * f);
    vec2 w2 = f * (0.5 + f * (2.0 - 1.5 * f)), w3 = f * f * (-0.5 + 0.5 * f), w12 = w1 + w2;
    vec2 p0 = (middle - 1.0) / size, p12 = (middle + w2 / w12) / size, p3 = (middle + 2.0) / size;
    vec3 centre = textureLod(smoothedPicture, p12, 0.0).rgb;
    vec3 left = textureLod(smoothedPicture, vec2(p0.x, p12.y), 0.0).rgb;
    vec3 right = textureLod(smoothedPicture, vec2(p3.x, p12.y), 0.0).rgb;
    vec3 low = textureLod(smoothedPicture, vec2(p12.x, p0.y), 0.0).rgb;
    vec3 high = textureLod(smoothedPicture, vec2(p12.x, p3.y), 0.0).rgb;
    float share = w12.x * w12.y + (w0.x + w3.x) * w12.y + w12.x * (w0.y + w3.y);
    vec3 sum = centre * w12.x * w12.y + (left * w0.x + right * w3.x) * w12.y + w12.x * (low * w0.y + high * w3.y);
    vec3 least = min(centre, min(min(left, right), min(low, high)));
    vec3 most = max(centre, max(max(left, right), max(low, high)));
    enlarged = vec4(clamp(sum / share, least, most), 1.0);
#ifdef TRANSPARENT
    enlarged.a = textureLod(smoothedCoverPicture, at / size, 0.0).r;
#endif
}
