#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "app/compare/limits_file.h"
#include "app/json/json.h"
#include "app/scene/overrides.h"
#include "render/compare/comparison.h"

namespace knuckle {

constexpr const char* GOLDEN_FILE = "golden.json";

/// Where the references of a driver come from.
struct GoldenRecord {
    std::string driver, device, program;
    std::string file = {};                        ///< Checksum of the file of states; empty: not known.
    std::map<uint64_t, std::string> states = {};  ///< hashText() of the state of each frame.
};

/// How far particles may be from where they were. Without a distance, states must have the same bits.
struct StateLimits {
    double distance = 0.0;  ///< [diameters]
    double share = 0.0;     ///< Of the particles that may be further away, 0-1.
};

/// A golden.json: a scene, or pictures of another program. assets/schema/golden.schema.json has every field.
struct Golden {
    std::string name = {};     ///< Path of its folder below that of all goldens, or the folder itself.
    std::string folder = {};   ///< Of its file.
    Json document = {};        ///< As it stands in the file.
    std::string problem = {};  ///< Why the file cannot be used; empty: it can.

    std::string scene = {};              ///< Path; empty: pictures of another program.
    std::vector<Override> changes = {};  ///< Of the scene, its size among them.
    std::vector<uint64_t> frames = {};   ///< In order, each once.

    std::string command = {};  ///< Empty: images are compared as they are.
    std::string commandFolder = {};
    std::vector<std::string> images = {};  ///< From that folder.

    StateLimits states = {};
    LimitsFile pictures = {};
    CompareSettings settings = {};                         ///< Without limits.
    bool statesAdvisory = true, picturesAdvisory = false;  ///< On a driver without references.
    std::map<std::string, GoldenRecord> recorded = {};     ///< By the name behind @; "" for references without one.

    bool ofScene() const { return !scene.empty(); }
    std::string path() const;
    /// Where an image of another program is.
    std::string imagePath(const std::string& image) const;
    /// Of "out/logo.png": "logo", the name of its reference without driver and ending.
    static std::string imageStem(const std::string& image);
    /// An image's reference.
    std::string imageReference(const std::string& image, const std::string& key) const;
    /// The name of a frame's reference, without driver and ending: "frame_0012".
    std::string frameStem(uint64_t frame) const;
    /// A reference: FOLDER/STEM@KEY.ENDING, without @ for an empty key. @param ending with its dot.
    std::string reference(const std::string& stem, const std::string& key, const std::string& ending = ".png") const;
    std::string statesFile(const std::string& key) const { return reference("states", key, ".states"); }
};

/// @throws InputError of one line with the JSON path.
Golden readGolden(const std::string& folder, const std::string& name);
/// The same for a document that no file holds yet.
Golden parseGolden(const std::string& folder, const std::string& name, const Json& document);
/// Writes its document, with what is recorded now. @throws as OutputFile.
void writeGolden(Golden& golden);
/// All goldens in a folder and below it that match any of the names or patterns; without any, all. Sorted by name. One
/// that cannot be read has its problem. @throws InputError where there are none.
std::vector<Golden> findGoldens(const std::string& folder, const std::vector<std::string>& names);

}  // namespace knuckle
