// State of an assembly in a substep (bodies that joints connect; a loose particle is one). A kernel that stores it
// declares BUFFER(Assembly, AssemblyState, assemblies).

uniform usamplerBuffer assemblyState;

struct Assembly {
    uint lastContact;   // the last substep in which anything touched it
    uint order;         // of the time integration in this substep: 1, or 2 for BDF2
};

/// @param states lastAssemblyState, if the kernel also stores assemblies.
Assembly fetchAssembly(usamplerBuffer states, uint assembly)
{
    uvec2 t = texelFetch(states, int(assembly)).xy;
    return Assembly(t.x, t.y);
}

Assembly fetchAssembly(uint assembly)
{
    return fetchAssembly(assemblyState, assembly);
}

/// The factor of h^2 by which an acceleration moves it in a substep of h: 4/9 for BDF2.
float accelerationFactor(Assembly assembly)
{
    return assembly.order == 2u ? 4.0 / 9.0 : 1.0;
}
