// What the geometry passes leave per pixel for the lighting: a normal and a colour in two words.

// Square roots spend the 8 bits a channel where the eye sees steps.
uint packAlbedo(vec3 albedo, float alpha)
{
    return packUnorm4x8(vec4(sqrt(clamp(albedo, 0.0, 1.0)), alpha));
}

vec3 unpackAlbedo(uint word)
{
    vec3 root = unpackUnorm4x8(word).rgb;
    return root * root;
}

// The ground's colour words have no alpha.
bool isGround(uvec2 surface)
{
    return surface.y >> 24 == 0u;
}

// Octahedral map of the unit sphere (Meyer et al. 2010).
uint packNormal(vec3 n)
{
    vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    vec2 folded = (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    return packSnorm2x16(n.z >= 0.0 ? p : folded);
}

vec3 unpackNormal(uint word)
{
    vec2 p = unpackSnorm2x16(word);
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    float fold = max(-n.z, 0.0);
    n.xy -= vec2(n.x >= 0.0 ? fold : -fold, n.y >= 0.0 ? fold : -fold);
    return normalize(n);
}
