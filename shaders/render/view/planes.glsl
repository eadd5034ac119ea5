// A camera that moves by itself stays in front of floors and walls that are planes.
vec3 inFrontOfPlanes(vec3 eye)
{
    for (uint i = 0u; i < frame.cameraPlaneCount; ++i)
        eye += max(frame.cameraClearance + planes[i].w - dot(planes[i].xyz, eye), 0.0) * planes[i].xyz;
    return eye;
}
