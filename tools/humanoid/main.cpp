#include <cstdio>
#include <exception>

#include "app/files/output.h"
#include "sim/actor/gltf/glb.h"
#include "tools/humanoid/humanoid.h"

/// Writes the project's own figure, assets/models/humanoid.glb.
int main(int argc, char** argv)
{
    if (argc != 2) {
        std::fprintf(stderr, "usage: make_humanoid humanoid.glb\n");
        return 2;
    }
    try {
        knuckle::OutputFile file(argv[1]);
        file.write(knuckle::toGlb(knuckle::makeHumanoid()));
        file.commit();
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "make_humanoid: %s\n", error.what());
        return 1;
    }
}
