// Small motions and forces of bodies in six dimensions: a place, and a turn about it (in Featherstone 2008 the turn
// comes first).
#include "math/symmetric.glsl"

struct Motion {
    vec3 t;   // of the point [m]
    vec3 r;   // about it [rad]
};

/// An impulse in units of mass times displacement, and its moment about the point.
struct Force {
    vec3 t;   // [kg m]
    vec3 r;   // [kg m2]
};

Motion scaled(Motion m, float s)
{
    return Motion(s * m.t, s * m.r);
}

Force scaled(Force f, float s)
{
    return Force(s * f.t, s * f.r);
}

/// Maps a motion to the force that it needs: [a, b^T; b, d], a and d symmetric.
struct Inertia {
    mat3 a;   // [kg]
    mat3 b;   // moments of moving [kg m]
    mat3 d;   // [kg m2]
};

/// The mean mass of an Inertia's a, which differs by direction where joints let go [kg].
float meanMass(mat3 a)
{
    return (a[0][0] + a[1][1] + a[2][2]) / 3.0;
}

/// The matrix of the cross product v x ...
mat3 crossMatrix(vec3 v)
{
    return mat3(0, v.z, -v.y, -v.z, 0, v.x, v.y, -v.x, 0);
}

/// The same inertia seen from the point at `arm` from the old one.
Inertia shifted(Inertia m, vec3 arm)
{
    mat3 x = crossMatrix(arm), bx = m.b * x, xax = transpose(x) * m.a * x;
    return Inertia(m.a, m.b + transpose(x) * m.a, m.d + bx + transpose(bx) + xax);
}

Force shifted(Force f, vec3 arm)
{
    return Force(f.t, f.r - cross(arm, f.t));
}

Motion shifted(Motion m, vec3 arm)
{
    return Motion(m.t + cross(m.r, arm), m.r);
}

Force product(Inertia m, Motion x)
{
    return Force(m.a * x.t + x.r * m.b, m.b * x.t + m.d * x.r);
}

Force add(Force x, Force y)
{
    return Force(x.t + y.t, x.r + y.r);
}

Inertia add(Inertia x, Inertia y)
{
    return Inertia(x.a + y.a, x.b + y.b, x.d + y.d);
}

/// The inverse of an inertia, which maps a force to the motion that it makes: [a, b^T; b, d].
struct Response {
    mat3 a;   // [1/kg]
    mat3 b;   // [1/(kg m)]
    mat3 d;   // [1/(kg m2)]
};

/// The same response seen from the point at `arm` from the old one.
Response shifted(Response w, vec3 arm)
{
    mat3 x = crossMatrix(-arm), xb = x * w.b;
    return Response(w.a + xb + transpose(xb) + x * w.d * transpose(x), w.b + w.d * transpose(x), w.d);
}
