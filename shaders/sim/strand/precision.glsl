// What strands are eliminated in. Between a light rope and a heavy load (HEAVY) mass matrices have entries thousands of
// times larger along the rope than across it, and where the rope is along no axis, floats lose the smaller ones.
#ifdef HEAVY
#define REAL double
#define REAL3 dvec3
#define REAL4 dvec4
#define REAL3X3 dmat3
#else
#define REAL float
#define REAL3 vec3
#define REAL4 vec4
#define REAL3X3 mat3
#endif

/// These keep the matrix regular, the larger one at a fixed end: for a taut strand held at both. On a drum links have
/// to agree with their contacts sooner.
#if defined(HEAVY) && defined(CONTACTS)
const float REGULAR = 1e-6;
#else
const float REGULAR = 1e-5;
#endif
const float REGULAR_END = 1e-3;

/// The most resistance to turning, relative to the mass of its nodes: more would be lost to rounding.
#ifdef HEAVY
const double MOST_TURNING = 1e7;
#else
const float MOST_TURNING = 30.0;
#endif
