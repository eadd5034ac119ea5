// One thread fits the shadow map and the burial grid to the particles' bounds, for the camera that frame_camera aimed,
// and puts the eye at its place on the lens.
#include "render/common/frame.glsl"
#include "render/view/axes.glsl"

layout(local_size_x = 1) in;
layout(std430) buffer View { FrameView view; };

// The map grows in steps, so that its texels do not move with every small change of the scene.
const float SIZE_STEPS_PER_OCTAVE = 3.0;

// Cells of two diameters or more over the particles.
void burialGrid(vec3 low, vec3 high)
{
    float diameter = 2.0 * frame.radius;
    // The outermost cells are reserved for particles outside the bounds.
    vec3 size = max((high - low + diameter) / float(BURIAL_CELLS - 3), vec3(2.0 * diameter));
    view.cellOrigin = vec4(low - frame.radius - size, 0.0);
    view.cellSize = vec4(size, float(SPACE_UNITS) * size.x * size.y * size.z / (diameter * diameter * diameter));
}

// A rectangle, as seen from the light, with all things that shade the ground, and their surroundings.
vec4 shadedRectangle(vec3 mapCentre, vec3 lightRight, vec3 lightUp, float halfSide)
{
    vec3 low = min(view.particleLow.xyz, frame.solidLow.xyz), high = max(view.particleHigh.xyz, frame.solidHigh.xyz);
    vec3 centre = 0.5 * (low + high) - mapCentre, extent = 0.5 * (high - low);
    vec2 middle = vec2(dot(centre, lightRight), dot(centre, lightUp));
    vec2 reach = vec2(dot(abs(lightRight), extent), dot(abs(lightUp), extent)) + frame.occlusionRadius + frame.radius;
    return vec4(middle - reach, middle + reach) / halfSide;
}

// What is sharp stays where it is in the picture.
void placeOnLens(vec3 lens)
{
    vec2 slope = frame.tanHalfFov * vec2(float(frame.width) / float(frame.height), 1.0);
    vec2 shift = frame.lens.xy + frame.lens.zw / (view.cameraBack.w * slope);
    view.cameraRight.w = shift.x;
    view.cameraUp.w = shift.y;
    view.cameraPosition.xyz = lens + frame.lens.z * view.cameraRight.xyz + frame.lens.w * view.cameraUp.xyz;
}

void main()
{
    vec3 right = view.cameraRight.xyz, up = view.cameraUp.xyz, back = view.cameraBack.xyz;
    vec3 lens = view.lightDepth.yzw;
    placeOnLens(lens);
    // Particles beyond the lit stage must not enlarge the shadow map.
    vec3 low = clamp(view.particleLow.xyz, frame.shadowLimitLow.xyz, frame.shadowLimitHigh.xyz);
    vec3 high = clamp(view.particleHigh.xyz, frame.shadowLimitLow.xyz, frame.shadowLimitHigh.xyz);
    burialGrid(low, high);
    low = min(low, frame.solidLow.xyz);
    high = max(high, frame.solidHigh.xyz);
    low = clamp(low, frame.shadowLimitLow.xyz, frame.shadowLimitHigh.xyz) - 2.0 * frame.radius;
    high = clamp(high, frame.shadowLimitLow.xyz, frame.shadowLimitHigh.xyz) + 2.0 * frame.radius;

    vec3 key = frame.keyDirection.xyz;
    vec3 lightRight = perpendicular(key);
    vec3 lightUp = cross(key, lightRight);
    vec3 centre = 0.5 * (low + high), extent = 0.5 * (high - low);
    float halfSide = max(dot(abs(lightRight), extent), dot(abs(lightUp), extent));
    halfSide = exp2(ceil(log2(halfSide) * SIZE_STEPS_PER_OCTAVE) / SIZE_STEPS_PER_OCTAVE);
    float halfDepth = dot(abs(key), extent) * 1.05;
    float texel = 2.0 * halfSide / frame.shadowSize;
    vec2 place = vec2(dot(centre, lightRight), dot(centre, lightUp));
    vec2 snap = floor(place / texel + 0.5) * texel - place;
    centre += snap.x * lightRight + snap.y * lightUp;

    view.shadedInLight = shadedRectangle(centre, lightRight, lightUp, halfSide);
    view.lightRight = vec4(lightRight, 0.0);
    view.lightUp = vec4(lightUp, 0.0);
    view.lightCentre = vec4(centre, halfSide);
    view.lightDepth = vec4(halfDepth, lens);
    mat3 toCamera = transpose(mat3(right, up, back));
    vec3 offset = view.cameraPosition.xyz - centre;
    view.viewToLightX = vec4(toCamera * lightRight, dot(offset, lightRight)) / halfSide;
    view.viewToLightY = vec4(toCamera * lightUp, dot(offset, lightUp)) / halfSide;
    view.viewToLightZ = -vec4(toCamera * key, dot(offset, key)) / halfDepth;
    view.keyInView = vec4(toCamera * key, 0.0);
    view.upInView = vec4(toCamera * vec3(0.0, 1.0, 0.0), 0.0);
}
