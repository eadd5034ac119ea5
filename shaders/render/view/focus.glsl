// What is sharp.

// Time in which the focus comes to where what it follows is, up to a share 1/e [s].
const float FOCUSING = 0.05;
const float NEAREST_FOCUS = 1e-3;   // [m]

// The distance along the camera's axis. `aimed`: what it looks at.
float sharpDistance(vec3 eye, vec3 back, vec3 aimed)
{
    if (frame.focusDistance > 0.0) return max(frame.focusDistance, NEAREST_FOCUS);
    if (frame.focusBit == 0u) return max(dot(eye - aimed, back), NEAREST_FOCUS);
    vec3 low = vec3(1e30), high = vec3(-1e30);
    for (uint i = 0u; i < BOUNDS_THREADS; ++i) {
        low = min(low, bounds[i].focusLow.xyz);
        high = max(high, bounds[i].focusHigh.xyz);
    }
    if (low.x > high.x) return max(dot(eye - aimed, back), NEAREST_FOCUS);
    float now = max(dot(eye - 0.5 * (low + high), back), NEAREST_FOCUS);
    return frame.trackSeconds < 0.0 ? now : mix(now, view.cameraBack.w, exp(-frame.trackSeconds / FOCUSING));
}
