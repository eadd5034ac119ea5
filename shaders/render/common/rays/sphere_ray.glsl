// The ray of a pixel of a sphere's image: what viewRay() would find, by numbers that come with the sphere.
flat in vec4 rayLine;
flat in float perFarDepth;      // [1/m]

vec3 pixelRay()
{
    return vec3(gl_FragCoord.xy * rayLine.xy + rayLine.zw, -1.0);
}
