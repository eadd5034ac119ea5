// Quaternions xyzw.

/// `from`, moved by as much as a turn moves v.
vec3 movedByTurn(vec3 from, vec4 q, vec3 v)
{
    vec3 t = 2.0 * cross(q.xyz, v);
    return from + q.w * t + cross(q.xyz, t);
}

vec3 rotate(vec4 q, vec3 v)
{
    return movedByTurn(v, q, v);
}

vec4 quaternionProduct(vec4 a, vec4 b)
{
    return vec4(a.w * b.xyz + b.w * a.xyz + cross(a.xyz, b.xyz), a.w * b.w - dot(a.xyz, b.xyz));
}

vec4 conjugate(vec4 q)
{
    return vec4(-q.xyz, q.w);
}

/// The rotation by |w| radians about w.
vec4 quaternionFromRotation(vec3 w)
{
    float angle = length(w);
    float s = angle > 1e-6 ? sin(0.5 * angle) / angle : 0.5;
    return vec4(s * w, cos(0.5 * angle));
}

/// The same for turns of up to a radian, not quite of length 1: its error is below 2e-6 of the turn's.
vec4 quaternionFromSmallRotation(vec3 w)
{
    float square = dot(w, w);
    return vec4((0.5 - square * (1.0 / 48.0 - square / 3840.0)) * w, 1.0 - square * (0.125 - square / 384.0));
}

/// How far a turn moves v, exact for small turns.
vec3 moveByTurn(vec4 q, vec3 v)
{
    return movedByTurn(vec3(0), q, v);
}

/// The angle of a turn about x, with as many whole turns as bring it nearest to another angle [rad].
float angleAboutX(vec4 turn, float near)
{
    const float WHOLE = 6.2831853;
    float further = 2.0 * atan(turn.x, turn.w) - near;
    return near + further - WHOLE * round(further / WHOLE);
}

mat3 matrixFromQuaternion(vec4 q)
{
    return mat3(rotate(q, vec3(1, 0, 0)), rotate(q, vec3(0, 1, 0)), rotate(q, vec3(0, 0, 1)));
}

/// The change of the columns of a rotation's matrix by a turn.
mat3 turnOfAxes(vec4 rotation, vec4 turn)
{
    mat3 axes = matrixFromQuaternion(rotation);
    return mat3(moveByTurn(turn, axes[0]), moveByTurn(turn, axes[1]), moveByTurn(turn, axes[2]));
}

vec4 quaternionFromMatrix(mat3 m)
{
    // Uses the largest component, so that the division is safe.
    float t = m[0][0] + m[1][1] + m[2][2];
    vec4 q;
    if (t > 0.0)
        q = vec4(m[1][2] - m[2][1], m[2][0] - m[0][2], m[0][1] - m[1][0], 1.0 + t);
    else if (m[0][0] > m[1][1] && m[0][0] > m[2][2])
        q = vec4(1.0 + m[0][0] - m[1][1] - m[2][2], m[0][1] + m[1][0], m[2][0] + m[0][2], m[1][2] - m[2][1]);
    else if (m[1][1] > m[2][2])
        q = vec4(m[0][1] + m[1][0], 1.0 + m[1][1] - m[0][0] - m[2][2], m[1][2] + m[2][1], m[2][0] - m[0][2]);
    else
        q = vec4(m[2][0] + m[0][2], m[1][2] + m[2][1], 1.0 + m[2][2] - m[0][0] - m[1][1], m[0][1] - m[1][0]);
    return normalize(q);
}
