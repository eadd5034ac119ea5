// Derivatives of pictures of a surface, by those of a Gaussian.
#include "render/common/frame_blocks.glsl"

const float WIDTH = 1.2;         // of the Gaussian [rest distances]: waves are wider than this, particles are not
const float MOST_TEXELS = 8.0;
const float MOST_STEP = 1.0;     // between neighbours that count as one surface [rest distances]

float restDistance()
{
    return frame.fluidRadius / SURFACE_RADIUS;
}

float gaussianWidth(float texel)
{
    return clamp(WIDTH * restDistance(), texel, MOST_TEXELS * texel);
}

/// So many texels to each side count.
int gaussianReach(float texel)
{
    return int(ceil(2.5 * gaussianWidth(texel) / texel));
}

// The Gaussian, its first and its second derivative.
vec3 weightsAt(float x, float width)
{
    float q = x / width, one = exp(-0.5 * q * q);
    return one * vec3(1.0, q / width, (q * q - 1.0) / (width * width));
}

float stepOf(float there, float here)
{
    float most = MOST_STEP * restDistance();
    return clamp(there - here, -most, most);
}
