// Properties of materials as fluids.

uniform samplerBuffer fluidMaterials;

/// Properties of a material as a fluid.
struct FluidMaterial {
    float smoothing;       // part of the difference to its neighbours that a step takes from a velocity, 0 ... 1
    float evenSmoothing;   // the share of that which leaves alone what changes evenly with place
    float tension;         // impulse of two particles that attract each other in a substep, over fluidAttraction()
                           // [kg m]
};

FluidMaterial fetchFluidMaterial(uint material)
{
    vec3 t = texelFetch(fluidMaterials, int(material)).xyz;
    return FluidMaterial(t.x, t.y, t.z);
}
