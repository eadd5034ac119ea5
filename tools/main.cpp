#include <cstdio>
#include <exception>
#include <map>
#include <string>

#include "sim/base/files/output_file.h"
#include "sim/rig/gltf/glb.h"
#include "tools/crate/crate.h"
#include "tools/dog/dog.h"
#include "tools/humanoid/humanoid.h"
#include "tools/spider/spider.h"

/// Writes one of the project's own models, as in assets/models.
int main(int argc, char** argv)
{
    const std::map<std::string, knuckle::Model (*)()> models{{"crate", knuckle::makeCrate},
                                                             {"dog", knuckle::makeDog},
                                                             {"humanoid", knuckle::makeHumanoid},
                                                             {"spider", knuckle::makeSpider}};
    const auto chosen = argc == 3 ? models.find(argv[1]) : models.end();
    if (chosen == models.end()) {
        std::fprintf(stderr, "usage: make_model NAME FILE.glb, where NAME is one of:");
        for (const auto& [name, make] : models) std::fprintf(stderr, " %s", name.c_str());
        std::fprintf(stderr, "\n");
        return 2;
    }
    try {
        knuckle::OutputFile file(argv[2]);
        file.write(knuckle::toGlb(chosen->second()));
        file.commit();
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "make_model: %s\n", error.what());
        return 1;
    }
}
