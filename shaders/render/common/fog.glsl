// Air that swallows light and gives its own (Beer and Lambert); it may thin upwards.
#include "render/common/frame_blocks.glsl"

#ifdef FOG

const float FAR_AWAY = 1e6;     // the sky [m]

// What is left of light from a distance [m] along a ray in view space, of any length.
float clearShare(vec3 ray, float far)
{
    float thinning = frame.develop.w, up = dot(normalize(ray), view.upInView.xyz) * thinning * far;
    float height = view.cameraPosition.y - frame.groundAlbedo.w;
    // The mean of exp(-up t) over the way, t from 0 to 1.
    float mean = abs(up) < 1e-3 ? 1.0 - 0.5 * up : (1.0 - exp(-max(up, -80.0))) / up;
    return exp(-frame.fog.w * exp(-thinning * height) * far * mean);
}
#endif
