// Where a sphere is in its body, for a pattern that turns with it.

uniform samplerBuffer spherePlaces;     // of the middle, in the body's axes [m]; w: the body, below 0 for none
uniform samplerBuffer bodyRotations;

flat out vec3 placeInBody;
flat out vec4 bodyTurn;

void placeSphere(int particle)
{
    vec4 place = texelFetch(spherePlaces, particle);
    placeInBody = place.xyz;
    bodyTurn = place.w < 0.0 ? vec4(0, 0, 0, 1) : texelFetch(bodyRotations, int(place.w));
}
