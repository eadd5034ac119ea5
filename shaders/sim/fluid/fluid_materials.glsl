// What materials do as fluids.

uniform samplerBuffer fluidMaterials;

/// What a material does as a fluid.
struct FluidMaterial {
    float smoothing;   // part of its difference to its neighbours that a step takes from a velocity, 0 ... 1
    float tension;     // what particles that attract each other get in a substep, over fluidAttraction() [kg m]
};

FluidMaterial fetchFluidMaterial(uint material)
{
    vec2 t = texelFetch(fluidMaterials, int(material)).xy;
    return FluidMaterial(t.x, t.y);
}
