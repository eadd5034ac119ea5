// A mesh in the shadow map: its triangles give the depth.

in vec3 viewPlace;
in vec3 viewNormal;

void main()
{
}
