#include "tests/render/golden.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "render/compare/difference_pictures.h"
#include "render/compare/verdict.h"
#include "render/reader/picture_file.h"
#include "tests/places.h"

namespace knuckle::test {

void expectGolden(const std::string& name, const Image& image)
{
    const std::string golden = inSource("tests/render/golden/" + name + ".png");
    if (std::getenv("KNUCKLE_RENEW_GOLDEN") != nullptr) {
        writePng(golden, image);
        return;
    }
    const Picture reference = readPicture(golden), drawn = pictureOf(image);
    const PictureComparison comparison = comparePictures(reference, drawn, {});
    const Verdict verdict = judge(comparison, {});
    if (verdict.equal) return;
    const std::string folder = std::filesystem::path(programPath()).parent_path().string() + "/golden_failures";
    std::filesystem::create_directories(folder);
    writePng(folder + "/" + name + ".png", image);
    writePng(folder + "/" + name + "_difference.png", differencePicture(reference, drawn, comparison));
    ADD_FAILURE() << name << ": " << verdictLine(comparison, verdict) << "; " << placesLine(comparison) << "; see "
                  << folder << "/" << name << ".png and _difference.png";
}

}  // namespace knuckle::test
