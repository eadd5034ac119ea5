// What comes to the eye from a surface with a finish.
#include "render/picture/finish_light.glsl"

bool hasFinish(uint alpha)
{
#ifdef GROUND_FINISH
    return alpha != FINISH_NONE;
#else
    return alpha != FINISH_NONE && alpha != 0u;
#endif
}

/// @param reach  Shares of the ambient and of the key light. @param through  What fluid leaves of the key light.
/// @param ambient  The light of the sky that is spread.
vec3 finishedSurface(Finish finish, vec3 albedo, Facing facing, vec3 p, vec2 reach, vec3 through, vec3 ambient)
{
    vec3 key = frame.keyColor.rgb * through * KEY_SHARE;
    vec3 light = key * directShare(finish, albedo, facing, view.keyInView.xyz, reach.y, reach.x, frame.keyDirection.w);
#ifdef LIGHTS
    for (int k = 0; k < LIGHTS; ++k) {
        vec3 strength, way = sourceWay(k, p, facing.normal, strength);
        light += strength * KEY_SHARE * directShare(finish, albedo, facing, way, 1.0, 1.0, 0.0);
    }
#endif
    vec3 mirrored = mirroredShare(straightReflectance(finish, albedo), finish.roughness, facing.upright);
    vec3 mirror = reflect(-facing.toEye, facing.normal);
    vec3 around = albedo * (1.0 - finish.metalness) * (1.0 - mirrored) * ambient * AMBIENT_SHARE +
                  mirrored * skyMirrored(mirror, finish.roughness) * reach.x;
    float coat = finish.coat * mirroredShare(vec3(COAT_REFLECTANCE), COAT_ROUGHNESS, facing.upright).x;
    return finish.emission * albedo + light + mix(around, skyMirrored(mirror, COAT_ROUGHNESS) * reach.x, coat);
}
