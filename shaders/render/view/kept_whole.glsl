// How a camera moves that keeps named particles whole in the picture: it lags behind the place that frames them, but
// never so far that a part is cut off, or that they become small.

// Most of the picture that they may fill, and least, of their height or width.
const float WHOLE = 0.97;
const float SMALL = 0.4;
// Time in which the camera turns to where they are, up to a share 1/e [s].
const float AIMING = 0.15;

// Share of the distance within which what needs it passes from the picture's width to its height, without a jolt.
const float SOFTENED = 0.25;

// A point on the camera's axis beside the particles' middle, and how far the camera is from it [m].
struct Stand {
    vec3 target;
    float distance;
};

// Where the sides of the view touch the box at the larger of both distances that this asks for, with the box in the
// middle both ways.
vec3 placeInTheMiddle(Box box, vec3 right, vec3 up, vec3 back)
{
    vec4 limits = limitsOf(box, right, up, back, slopeOf(frame.frameShare));
    vec2 away = 0.5 * (limits.xy - limits.zw) / slopeOf(frame.frameShare);
    float distance = max(away.x, away.y), apart = abs(away.x - away.y);
    distance += 0.5 * (length(vec2(apart, SOFTENED * distance)) - apart);
    for (int round = 0; round < 4; ++round)
        limits = limitsOf(box, right, up, back, 0.5 * (limits.xy - limits.zw) / distance);
    vec2 middle = 0.5 * (limits.xy + limits.zw);
    return middle.x * right + middle.y * up + distance * back;
}

// `before`: where the camera would have been at its last look, had it no limits; if limits were kept in mind it would
// stop abruptly where the particles do.
Stand keptWhole(Stand before, Box box, vec3 right, vec3 up, vec3 back)
{
    vec3 centre = 0.5 * (box.low + box.high);
    box.low -= centre;
    box.high -= centre;
    vec3 eye = placeInTheMiddle(box, right, up, back);
    Stand now = Stand(centre + eye - dot(eye, back) * back, dot(eye, back));
    if (frame.trackSeconds < 0.0) before = now;
    float growth = log(before.distance / now.distance);
    growth *= exp(-max(frame.trackSeconds, 0.0) / (growth < 0.0 ? GROWING : SHRINKING));
    vec3 lag = (before.target - now.target) * exp(-max(frame.trackSeconds, 0.0) / AIMING);
    view.trackedLow = vec4(now.target + lag, now.distance * exp(growth));
    growth = bent(growth, growth < 0.0 ? 0.5 * log(WHOLE / frame.frameShare) : log(frame.frameShare / SMALL));
    now.distance *= exp(growth);
    // How far the camera may be off before the box leaves the picture.
    vec2 slope = slopeOf(WHOLE), side = vec2(dot(eye, right), dot(eye, up));
    vec4 limits = limitsOf(box, right, up, back, slope);
    vec2 below = side + slope * now.distance - limits.xy, above = limits.zw - side + slope * now.distance;
    float sideways = dot(lag, right), upwards = dot(lag, up);
    now.target += bent(sideways, sideways < 0.0 ? below.x : above.x) * right +
                  bent(upwards, upwards < 0.0 ? below.y : above.y) * up;
    return now;
}
