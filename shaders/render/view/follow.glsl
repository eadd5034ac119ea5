// A camera that goes along with an object.

// The mean of its bodies' centres. Before it is there, where it will be.
vec3 followedPlace()
{
    vec3 sum = vec3(0.0), away = vec3(frame.cameraPosition.w, frame.cameraTarget.w, 0.0);
    for (uint i = 0; i < frame.followedBodyCount; ++i) sum += centres[frame.followedBodyStart + i].xyz;
    vec3 mean = sum / float(frame.followedBodyCount);
    return away.y > 0.0 && mean.y > 0.5 * away.y ? mean - away : mean;
}

// Where it is beside what it follows. `back`: from what it looks at.
vec3 placeThatFollows(inout vec3 back)
{
    vec3 now = followedPlace(), arm = frame.cameraPosition.xyz - frame.cameraTarget.xyz;
    vec3 lag = tracked(boxOf(now, now)).low - now;
    float limit = BEHIND * length(arm) * min(slopeOf(1.0).x, slopeOf(1.0).y), off = max(length(lag), 1e-20);
    vec3 target = now + bent(off, limit) / off * lag + frame.cameraTarget.xyz;
    arm = turnedAround(arm, turnAroundSolids(target, arm));
    vec3 eye = inFrontOfSolids(target, inFrontOfPlanes(target + arm));
    back = normalize(eye - target);
    return eye;
}
