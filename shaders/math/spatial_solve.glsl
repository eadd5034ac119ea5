// The motion of an inertia for a force.
#include "math/cholesky.glsl"
#include "math/spatial.glsl"

/// The resistance to moves if turns are free: a - b^T d^-1 b.
mat3 withoutTurns(Inertia m, Cholesky d)
{
    mat3 turns = transpose(mat3(forward(d, m.b[0]), forward(d, m.b[1]), forward(d, m.b[2])));
    mat3 left = m.a;
    for (int k = 0; k < 3; ++k) left -= outerProduct(d.inversePivots[k] * turns[k], turns[k]);
    return left;
}

/// An inertia factored for solving.
struct FactoredInertia {
    Cholesky turn;   // of d
    Cholesky move;   // of the rest of a without turns
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
