// Where a sphere is in its body, for a pattern that turns with it.

uniform samplerBuffer spherePlaces;     // of the middle, in the body's axes [m]; w: 4 times the body, below 0 for none,
                                        // and the axis along which it is longest
uniform samplerBuffer bodyRotations;

flat out vec4 placeInBody;              // w: that axis
flat out vec4 bodyTurn;
flat out uint patternSeed;              // the body; loose ones have their own places

void placeSphere(int particle)
{
    vec4 place = texelFetch(spherePlaces, particle);
    int which = int(place.w);
    placeInBody = vec4(place.xyz, which < 0 ? 0 : which & 3);
    patternSeed = which < 0 ? 0u : uint(which >> 2);
    bodyTurn = which < 0 ? vec4(0, 0, 0, 1) : texelFetch(bodyRotations, which >> 2);
}
