// Scene-linear light to display values.

// Film's curve and the display's gamma in one rational function (J. Hejl and R. Burgess-Dawson, in J. Hable, "Filmic
// Tonemapping Operators", 2010): without powers, which are slow on software drivers.
vec3 filmic(vec3 light)
{
    vec3 x = max(light - 0.004, 0.0);
    return x * (6.2 * x + 0.5) / (x * (6.2 * x + 1.7) + 0.06);
}
