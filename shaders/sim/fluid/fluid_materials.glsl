// Properties of materials as fluids.

uniform samplerBuffer fluidMaterials;

/// Properties of a material as a fluid.
struct FluidMaterial {
    float smoothing;       // part of the difference to its neighbours that a step takes from a velocity, 0 ... 1;
                           // below 0: it is viscous (sim/fluid/viscous)
    float tension;         // impulse of two particles that attract each other in a substep, over fluidAttraction()
                           // [kg m]
};

FluidMaterial fetchFluidMaterial(uint material)
{
    vec2 t = texelFetch(fluidMaterials, int(material)).xy;
    return FluidMaterial(t.x, t.y);
}
