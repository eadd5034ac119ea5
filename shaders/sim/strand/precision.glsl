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
