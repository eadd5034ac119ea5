// What the lit ground throws back on what is near it.

// In place of the light from below, at a place in view space.
vec3 lightFromBelow(vec3 p)
{
    vec3 sunlit = frame.keyColor.rgb * max(frame.keyDirection.y, 0.0) * (KEY_SHARE / AMBIENT_SHARE);
    float height = dot(p, view.upInView.xyz) + view.cameraPosition.y - frame.groundAlbedo.w;
    float far = max(height, 0.0) / frame.backdrop.w;
    return mix(frame.groundColor.rgb, frame.bounce.rgb * (sunlit + frame.skyColor.rgb),
               frame.bounce.w / (1.0 + far * far));
}
