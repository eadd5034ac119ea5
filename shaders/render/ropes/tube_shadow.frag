// A rope in the shadow map: triangles give the depth.
in vec3 viewNormal;
in vec3 viewPlace;
in vec3 colorRoots;
in float strandAngle;

void main() {}
