// An obstacle of glass, over the picture of all else.
#include "render/common/frame_blocks.glsl"
#include "render/colliders/ray_shapes.glsl"

flat in vec4 shapePosition;
flat in vec4 shapeOrientation;
flat in vec4 shapeHalfExtents;
flat in vec4 shapeColor;
in vec3 boxPoint;

float hitFrom(vec3 origin, vec3 way, out vec3 normal)
{
    return rayShape(uint(shapeColor.w), origin, way, shapeHalfExtents.xyz, shapePosition.w, normal);
}

#include "render/common/rays/glass.glsl"

vec3 toShape(vec3 v) { return rotateBack(shapeOrientation, directionToWorld(v)); }
vec3 fromShape(vec3 v) { return directionToView(rotate(shapeOrientation, v)); }

void main()
{
    vec3 normal, ray = viewRay(gl_FragCoord.xy), way = toShape(normalize(ray));
    vec3 eye = rotateBack(shapeOrientation, view.cameraPosition.xyz - shapePosition.xyz);
    float along = hitFrom(eye, way, normal), depth = along / length(ray);
    if (along <= 0.0 || isHidden(depth)) discard;
    vec3 half_ = shapeHalfExtents.xyz;
    Passage through = passGlass(eye + along * way, way, normal, 2.0 * length(half_));
    float thick = through.inside / (2.0 * min(half_.x, min(half_.y, half_.z)));
    through.exit = fromShape(through.exit - eye);
    through.way = fromShape(through.way);
    picture = glassPicture(depth * ray, fromShape(normal), through, shapeColor.rgb, thick);
    gl_FragDepth = depth / frame.farDepth;
}
