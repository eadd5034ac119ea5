// What a substep knows of an assembly (what joints connect; a loose particle is one). A kernel that stores it declares
// BUFFER(Assembly, AssemblyState, assemblies).

uniform usamplerBuffer assemblyState;

struct Assembly {
    uint lastContact;   // the last substep in which anything touched it
    uint order;         // of the time integration in this substep: 1, or 2 for BDF2
};

/// Of a kernel that stores assemblies, too: `states` is lastAssemblyState.
Assembly fetchAssembly(usamplerBuffer states, uint assembly)
{
    uvec2 t = texelFetch(states, int(assembly)).xy;
    return Assembly(t.x, t.y);
}

Assembly fetchAssembly(uint assembly)
{
    return fetchAssembly(assemblyState, assembly);
}

/// By how much of h^2 times an acceleration it moves in a substep of h: BDF2 takes 4/9 of it.
float accelerationFactor(Assembly assembly)
{
    return assembly.order == 2u ? 4.0 / 9.0 : 1.0;
}
