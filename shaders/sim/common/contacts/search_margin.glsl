// Positions for which contact candidates were found, and how far movers may drift from there until the next search.

struct SearchCentre {
    vec3 position;   // of the mover's centre [m]
    float margin;    // how far its particles may drift [m]
};

SearchCentre fetchSearchCentre(samplerBuffer searchCentres, uint mover)
{
    vec4 t = texelFetch(searchCentres, int(mover));
    return SearchCentre(t.xyz, t.w);
}

vec4 packSearchCentre(SearchCentre centre)
{
    return vec4(centre.position, centre.margin);
}

/// By how much the margin of a mover exceeds the common one [m]; above 0 for fast ones.
float extraMargin(SearchCentre centre)
{
    return centre.margin - sim.drift;
}
