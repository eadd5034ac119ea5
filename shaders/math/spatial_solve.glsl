// Which motion a force gives to an inertia.
#include "math/cholesky.glsl"
#include "math/spatial.glsl"

/// What resists moves where turns are let go, one after another: a - b^T d^-1 b.
mat3 withoutTurns(Inertia m, Cholesky d)
{
    vec3 x = vec3(m.b[0].x, m.b[1].x, m.b[2].x), y = vec3(m.b[0].y, m.b[1].y, m.b[2].y);
    vec3 z = vec3(m.b[0].z, m.b[1].z, m.b[2].z);
    y -= d.lower.x * x;
    z -= d.lower.y * x + d.lower.z * y;
    return m.a - outerProduct(d.inversePivots.x * x, x) - outerProduct(d.inversePivots.y * y, y) -
           outerProduct(d.inversePivots.z * z, z);
}

/// An inertia made ready to be solved.
struct FactoredInertia {
    Cholesky turn;   // of d
    Cholesky move;   // of what is left of a without turns
    mat3 b;
};

FactoredInertia factored(Inertia m)
{
    Cholesky turn = choleskyOf(m.d);
    return FactoredInertia(turn, choleskyOf(withoutTurns(m, turn)), m.b);
}

/// The motion that a force gives.
Motion solve(FactoredInertia m, Force f)
{
    vec3 t = solve(m.move, f.t - solve(m.turn, f.r) * m.b);
    return Motion(t, solve(m.turn, f.r - m.b * t));
}

Response inverseOf(FactoredInertia m)
{
    mat3 a = solve(m.move, mat3(1)), turning = solve(m.turn, mat3(1));
    mat3 b = -turning * m.b * a;
    return Response(a, b, turning - b * transpose(m.b) * turning);
}
