// What is sharp.

// Time in which the focus comes to where what it follows is, up to a share 1/e [s].
const float FOCUSING = 0.05;
const float NEAREST_FOCUS = 1e-3;   // [m]

// What the camera looks at, once it is aimed.
vec3 aimedAt()
{
    if (frame.cameraMode == CAMERA_FIXED) return frame.cameraTarget.xyz;
    if (frame.cameraMode == CAMERA_FOLLOWS) return frame.cameraTarget.xyz + followedPlace();
    if (frame.cameraMode != CAMERA_LOOKS && frame.framedBit != 0u) return view.trackedLow.xyz;
    return 0.5 * (view.trackedLow.xyz + view.trackedHigh.xyz);
}

// The distance along the camera's axis.
float sharpDistance(vec3 eye, vec3 back)
{
    float aimed = max(dot(eye - aimedAt(), back), NEAREST_FOCUS);
    if (frame.focusDistance > 0.0) return max(frame.focusDistance, NEAREST_FOCUS);
    if (frame.focusBit == 0u) return aimed;
    vec3 low = vec3(1e30), high = vec3(-1e30);
    for (uint i = 0u; i < BOUNDS_THREADS; ++i) {
        low = min(low, bounds[i].focusLow.xyz);
        high = max(high, bounds[i].focusHigh.xyz);
    }
    if (low.x > high.x) return aimed;
    float now = max(dot(eye - 0.5 * (low + high), back), NEAREST_FOCUS);
    return frame.trackSeconds < 0.0 ? now : mix(now, view.cameraBack.w, exp(-frame.trackSeconds / FOCUSING));
}
