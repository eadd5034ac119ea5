// The motion of each body of a tree for a force on it, with all that its joints move along: from the root on, its
// parent's response at the joint, plus what its joint leaves free.
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
#define WRITTEN(t) rootFactors[ROOT_FACTOR_TEXELS * k + uint(t)]
    return inverseOf(ROOT_FACTOR_FROM(WRITTEN));
#undef WRITTEN
}

mat3 freeTurns(JointFactor f, uint freedom, mat3 torques)
{
    return mat3(freeTurn(f, freedom, torques[0]), freeTurn(f, freedom, torques[1]), freeTurn(f, freedom, torques[2]));
}

void respond(uint k)
{
    Joint joint = fetchJoint(k);
    Response w = Response(mat3(0), mat3(0), mat3(0));
    uint freedom = fetchFreedom(k);
    bool free = responds(joint.body), isRoot = freedom == JOINT_NONE;
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
    mat3 byMove = -freeTurns(f, freedom, m.b), byTurn = mat3(1) - freeTurns(f, freedom, m.d);
    mat3 mixed = byTurn * w.b * transpose(byMove);
    mat3 turning = byMove * w.a * transpose(byMove) + mixed + transpose(mixed) + byTurn * w.d * transpose(byTurn) +
                   freeTurns(f, freedom, mat3(1));
    storeResponse(joint.body, shifted(Response(w.a, byMove * w.a + byTurn * w.b, turning), -f.arm));
}
