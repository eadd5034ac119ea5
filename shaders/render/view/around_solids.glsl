// A camera before which a solid stands goes around it, as little as it has to: if it only came nearer, what it looks at
// would fill the picture, or be cut off.

// Shares of the way to what it looks at: below the first it turns, above the second it turns back, and below the third
// it is there at once, for there is nothing to see on the way.
const float HIDDEN = 0.85, OPEN = 0.95, BLIND = 0.5;
// Time in which it turns, up to a share 1/e [s].
const float TURNING = 0.3;
const float TURN_STEP = 0.2618;   // 15 degrees
const int TURN_STEPS = 12;        // up to the opposite side

vec3 turnedAround(vec3 arm, float angle)
{
    return vec3(cos(angle) * arm.x + sin(angle) * arm.z, arm.y, cos(angle) * arm.z - sin(angle) * arm.x);
}

// Where it is best to be: the smallest turn to either side from which the way is free, or the one that is most so.
float clearestTurn(vec3 target, vec3 arm, float straight, float first)
{
    float best = straight, angle = 0.0;
    for (int k = 2; k < 2 * TURN_STEPS + 2 && best < OPEN; ++k) {   // to one side, to the other, further
        float tried = (k % 2 == 0 ? first : -first) * float(k / 2) * TURN_STEP;
        float share = freeWay(target, turnedAround(arm, tried));
        if (share > best + 0.05) best = share, angle = tried;
    }
    return angle;
}

// How far the camera is turned about +Y around its target [rad]; kept from frame to frame. `arm`: from there to where
// it would be.
float turnAroundSolids(vec3 target, vec3 arm)
{
    bool isFirst = frame.trackSeconds < 0.0;
    float turn = isFirst ? 0.0 : view.trackedHigh.w, straight = freeWay(target, arm), wanted = 0.0;
    if (straight < OPEN) {
        float now = turn == 0.0 ? straight : freeWay(target, turnedAround(arm, turn));
        wanted = now >= HIDDEN ? turn : clearestTurn(target, arm, straight, turn < 0.0 ? -1.0 : 1.0);
    }
    if (turn != wanted) {
        turn = isFirst ? wanted : mix(wanted, turn, exp(-frame.trackSeconds / TURNING));
        if (freeWay(target, turnedAround(arm, turn)) < BLIND) turn = wanted;
    }
    if (abs(turn) < 1e-4) turn = 0.0;
    view.trackedHigh.w = turn;
    return turn;
}
