// What a substep knows of an assembly (what joints connect; a loose particle is one). A kernel that stores it declares
// BUFFER(Assembly, AssemblyState, assemblies).

uniform usamplerBuffer assemblyState;

struct Assembly {
    uint lastContact;   // the last substep in which anything touched it
    uint order;         // of the time integration in this substep: 1, or 2 for BDF2
};

Assembly fetchAssembly(uint assembly)
{
    uvec2 t = texelFetch(assemblyState, int(assembly)).xy;
    return Assembly(t.x, t.y);
}

/// By how much of h^2 times an acceleration it moves in a substep of h: BDF2 takes 4/9 of it.
float accelerationFactor(Assembly assembly)
{
    return assembly.order == 2u ? 4.0 / 9.0 : 1.0;
}
