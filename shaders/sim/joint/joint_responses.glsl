// How each body of a tree answers to a force, with all that its joints move along: from the root on, as its parent does
// at the joint, and by what its joint leaves free.
BUFFER(vec4, BodyResponses, bodyResponses);

void storeResponse(uint body, Response w)
{
    for (int line = 0; line < 3; ++line) {
        bodyResponses[9u * body + uint(line)].xyz = w.a[line];
        bodyResponses[9u * body + 3u + uint(line)].xyz = w.b[line];
        bodyResponses[9u * body + 6u + uint(line)].xyz = w.d[line];
    }
}

mat3 loadResponseBlock(uint first)
{
    return mat3(bodyResponses[first].xyz, bodyResponses[first + 1u].xyz, bodyResponses[first + 2u].xyz);
}

Response loadResponse(uint body)
{
    return Response(loadResponseBlock(9u * body), loadResponseBlock(9u * body + 3u), loadResponseBlock(9u * body + 6u));
}

void respond(uint k)
{
    TreeJoint joint = fetchTreeJoint(k);
#define WRITTEN(t) jointFactors[JOINT_FACTOR * k + uint(t)]
    JointFactor f = JOINT_FACTOR_FROM(WRITTEN);
#undef WRITTEN
    if (joint.freedom == JOINT_NONE) {
        storeResponse(joint.body, Response(f.inertia.a, f.inertia.b, f.inertia.d));
        return;
    }
    Response w = Response(mat3(0), mat3(0), mat3(0));
    if (joint.parentJoint != NONE) w = shifted(loadResponse(joint.parent), f.parentArm);
    Inertia m = f.inertia;
    mat3 byMove = -f.free * m.b, byTurn = mat3(1) - f.free * m.d;
    mat3 mixed = byTurn * w.b * transpose(byMove);
    mat3 turning = byMove * w.a * transpose(byMove) + mixed + transpose(mixed) + byTurn * w.d * transpose(byTurn) +
                   f.free;
    storeResponse(joint.body, shifted(Response(w.a, byMove * w.a + byTurn * w.b, turning), -f.arm));
}
