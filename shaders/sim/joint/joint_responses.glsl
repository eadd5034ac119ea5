// How each body of a tree answers to a force, with all that its joints move along: from the root on, as its parent does
// at the joint, and by what its joint leaves free.
BUFFER(vec4, BodyResponses, bodyResponses);

void storeResponse(uint body, Response w)
{
    uint first = BODY_RESPONSE_TEXELS * body;
    for (int line = 0; line < 3; ++line) {
        bodyResponses[first + uint(line)].xyz = w.a[line];
        bodyResponses[first + 3u + uint(line)].xyz = w.b[line];
        bodyResponses[first + 6u + uint(line)].xyz = w.d[line];
    }
}

mat3 loadResponseBlock(uint first)
{
    return mat3(bodyResponses[first].xyz, bodyResponses[first + 1u].xyz, bodyResponses[first + 2u].xyz);
}

Response loadResponse(uint body)
{
    uint first = BODY_RESPONSE_TEXELS * body;
    return Response(loadResponseBlock(first), loadResponseBlock(first + 3u), loadResponseBlock(first + 6u));
}

Response rootResponse(uint k)
{
#define WRITTEN(t) rootResponses[ROOT_RESPONSE_TEXELS * k + uint(t)]
    return ROOT_RESPONSE_FROM(WRITTEN);
#undef WRITTEN
}

void respond(uint k)
{
    JointInfo joint = fetchJoint(k);
    Response w = Response(mat3(0), mat3(0), mat3(0));
    bool free = responds(joint.body), isRoot = fetchFreedom(k) == JOINT_NONE;
    if (free && isRoot) w = rootResponse(k);
    if (!free || isRoot) {
        storeResponse(joint.body, w);
        return;
    }
#define WRITTEN(t) jointFactors[JOINT_FACTOR_TEXELS * k + uint(t)]
    JointFactor f = JOINT_FACTOR_FROM(WRITTEN);
#undef WRITTEN
    if (joint.parentJoint != NONE) w = shifted(loadResponse(joint.parent), f.parentArm);
    Inertia m = f.inertia;
    mat3 byMove = -f.free * m.b, byTurn = mat3(1) - f.free * m.d;
    mat3 mixed = byTurn * w.b * transpose(byMove);
    mat3 turning = byMove * w.a * transpose(byMove) + mixed + transpose(mixed) + byTurn * w.d * transpose(byTurn) +
                   f.free;
    storeResponse(joint.body, shifted(Response(w.a, byMove * w.a + byTurn * w.b, turning), -f.arm));
}
