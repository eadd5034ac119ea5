// Cloth or a soft body in the shadow map: triangles give the depth.
in vec3 viewNormal;
in vec3 viewPlace;
in vec3 colorRoots;
in vec3 weave;

void main() {}
