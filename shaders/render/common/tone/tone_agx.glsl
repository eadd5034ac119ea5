// A film's way from saturated colours to white (T. Sobotka, "AgX", 2022; matrices and polynomial of B. Wrensch,
// "Minimal AgX Implementation", 2023).

const mat3 AGX_IN = mat3(0.842479062253094, 0.0423282422610123, 0.0423756549057051,
                         0.0784335999999992, 0.878468636469772, 0.0784336,
                         0.0792237451477643, 0.0791661274605434, 0.879142973793104);
const mat3 AGX_OUT = mat3(1.19687900512017, -0.0528968517574562, -0.0529716355144438,
                          -0.0980208811401368, 1.15190312990417, -0.0980434501171241,
                          -0.0990297440797205, -0.0989611768448433, 1.15107367264116);
const float AGX_LOW = -12.47393;    // binary logarithms of light
const float AGX_HIGH = 4.026069;
const int BISECTIONS = 16;

vec3 agxCurve(vec3 x)
{
    return (((((15.5 * x - 40.14) * x + 31.96) * x - 6.868) * x + 0.4298) * x + 0.1191) * x - 0.00232;
}

vec3 displayed(vec3 light)
{
    vec3 part = (log2(max(AGX_IN * max(light, 0.0), 1e-10)) - AGX_LOW) / (AGX_HIGH - AGX_LOW);
    return clamp(AGX_OUT * agxCurve(clamp(part, 0.0, 1.0)), 0.0, 1.0);
}

vec3 lightOf(vec3 shown)
{
    vec3 wanted = inverse(AGX_OUT) * shown, low = vec3(0.0), high = vec3(1.0);
    for (int k = 0; k < BISECTIONS; ++k) {
        vec3 middle = 0.5 * (low + high), above = vec3(greaterThan(agxCurve(middle), wanted));
        high = mix(high, middle, above);
        low = mix(middle, low, above);
    }
    return max(inverse(AGX_IN) * exp2(mix(vec3(AGX_LOW), vec3(AGX_HIGH), low)), 0.0);
}
