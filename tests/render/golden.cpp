#include "tests/render/golden.h"
#include "tests/places.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace knuckle::test {

namespace {

constexpr double MAX_MEAN = 1.0;
constexpr double MAX_CHANGED_FRACTION = 0.01;
constexpr uint32_t CHANGED_BEYOND = 24;

}  // namespace

void expectGolden(const std::string& name, const Image& image)
{
    const std::string golden = inSource("tests/render/golden/" + name + ".png");
    if (std::getenv("KNUCKLE_RENEW_GOLDEN") != nullptr) {
        writePng(golden, image);
        return;
    }
    const ImageDifference difference = compareImages(image, readImage(golden), CHANGED_BEYOND);
    if (difference.meanAbsolute <= MAX_MEAN && difference.changedFraction <= MAX_CHANGED_FRACTION) return;
    const std::string folder = std::filesystem::path(programPath()).parent_path().string() + "/golden_failures";
    std::filesystem::create_directories(folder);
    writePng(folder + "/" + name + ".png", image);
    writePng(folder + "/" + name + "_difference.png", difference.picture);
    ADD_FAILURE() << name << ": mean difference " << difference.meanAbsolute << " (at most " << MAX_MEAN
                  << "), changed share " << difference.changedFraction << " (at most " << MAX_CHANGED_FRACTION
                  << "); see " << folder << "/" << name << ".png and _difference.png";
}

}  // namespace knuckle::test
