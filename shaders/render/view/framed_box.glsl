// The box that an automatic camera is to show, from the bounds that frame_bounds found, and how it follows.

// Stray particles further from the mean than this many standard deviations must not make the rest small.
const float STRAY = 3.0;

// For all sides in turn: with the circle that the corners describe.
Box seenAround(Box box)
{
    vec2 centre = 0.5 * (box.low.xz + box.high.xz);
    float around = 0.5 * length(box.high.xz - box.low.xz);
    return boxOf(vec3(centre.x - around, box.low.y, centre.y - around),
                 vec3(centre.x + around, box.high.y, centre.y + around));
}

// Of the named particles, all of them, wherever they are; low > high if none is there.
Box namedBox()
{
    vec3 low = vec3(1e30), high = vec3(-1e30);
    vec4 most = vec4(-1e30), least = vec4(1e30);
    for (uint i = 0u; i < BOUNDS_THREADS; ++i) {
        low = min(low, bounds[i].framedLow.xyz);
        high = max(high, bounds[i].framedHigh.xyz);
        most = max(most, bounds[i].framedMost);
        least = min(least, bounds[i].framedLeast);
    }
    float around = frame.radius + frame.boundsMargin;
    low -= around;
    high += around;
    vec4 reach = vec4(sqrt(3.0) * around);
    vec4 corners = vec4(high.x + high.y + high.z, high.y + high.z - low.x, high.x + high.z - low.y,
                        high.x + high.y - low.z);
    vec4 opposite = vec4(low.x + low.y + low.z, low.y + low.z - high.x, low.x + low.z - high.y,
                         low.x + low.y - high.z);
    return Box(low, high, max(corners - most - reach, 0.0), max(least - reach - opposite, 0.0));
}

// Of all particles but strays, with their way down to the ground.
Box commonBox()
{
    vec3 low = vec3(1e30), high = vec3(-1e30), sum = vec3(0.0), squares = vec3(0.0);
    float count = 0.0;
    for (uint i = 0u; i < BOUNDS_THREADS; ++i) {
        low = min(low, bounds[i].low.xyz);
        high = max(high, bounds[i].high.xyz);
        sum += bounds[i].sum.xyz;
        count += bounds[i].sum.w;
        squares += bounds[i].squares.xyz;
    }
    if (count == 0.0) {
        low = frame.shadowLimitLow.xyz;
        high = frame.shadowLimitHigh.xyz;
    }
    view.particleLow = vec4(low, 0.0);
    view.particleHigh = vec4(high, 0.0);
    if (count == 0.0) return boxOf(low, high);
    vec3 mean = sum / count;
    vec3 reach = STRAY * sqrt(max(squares / count - mean * mean, 0.0));
    vec3 middle = 0.5 * (frame.shadowLimitLow.xyz + frame.shadowLimitHigh.xyz) + mean;
    low = max(low, middle - reach) - frame.radius - frame.boundsMargin;
    high = min(high, middle + reach) + frame.radius + frame.boundsMargin;
    vec3 size = high - low;
    // It will come down, but the picture includes a ground far below only when it comes near.
    low.y = min(low.y, max(frame.groundAlbedo.w, low.y - max(size.x, max(size.y, size.z))));
    return boxOf(low, high);
}

Box framedBox()
{
    Box box = commonBox();
    Box named = namedBox();
    if (named.low.x <= named.high.x) return named;
    return frame.cameraMode == CAMERA_FRAMES_AROUND ? seenAround(box) : box;
}

Box tracked(Box now)
{
    Box before = boxOf(view.trackedLow.xyz, view.trackedHigh.xyz);
    if (frame.trackSeconds < 0.0) before = now;
    Box box = boxOf(mix(before.low, now.low, approachFraction(lessThan(now.low, before.low))),
                    mix(before.high, now.high, approachFraction(greaterThan(now.high, before.high))));
    view.trackedLow = vec4(box.low, 0.0);
    view.trackedHigh.xyz = box.high;
    return box;
}
