#include "app/export/exporters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "app/export/bodies.h"
#include "app/export/bvh.h"
#include "app/export/gltf.h"
#include "app/export/layers/layers.h"
#include "app/export/measures.h"
#include "app/export/points/bgeo.h"
#include "app/export/points/ply.h"
#include "app/export/surface/surface.h"
#include "app/export/vdb/vdb.h"
#include "app/export/vtk/vtk.h"
#include "sim/base/errors.h"
#include "sim/base/files/endings.h"

namespace knuckle {

namespace {

template <typename T>
std::unique_ptr<Exporter> make(const std::string& path)
{
    return std::make_unique<T>(path);
}

/// Contents of a file and the endings that its name may have; a folder has no endings.
struct ExportPlace {
    const char* what = "";
    std::vector<const char*> endings;
};

struct ExportKind {
    const char *word, *value, *help;
    ExportPlace place;
    std::unique_ptr<Exporter> (*make)(const std::string& path);
};

/// For `--export`, its help, and the list in docs/output.md (scripts/export_table.sh).
const std::vector<ExportKind>& exportKinds()
{
    static const ExportPlace TABLE{"a table", {".csv", ".txt", ""}};
    static const std::vector<ExportKind> KINDS{
        {"ply",
         "FOLDER",
         "per frame: id, position, velocity, body and material of each particle, binary PLY",
         {},
         make<PlyExport>},
        {"vtk",
         "FOLDER",
         "per frame: the same, radius, and density of fluids, VTK PolyData; frames.pvd is all of them",
         {},
         make<VtkExport>},
        {"bgeo",
         "FOLDER",
         "per frame: the same as points, P, v, id, pscale ..., Houdini's classic .bgeo, for Partio and splashsurf",
         {},
         make<BgeoExport>},
        {"bodies", "FILE.csv", "frame, body, object, name, position, quaternion, velocity, angular velocity, CSV",
         TABLE, make<BodyExport>},
        {"measures", "FILE.csv", "per frame: contacts, penetration, joint gaps, rigidity, strain, density, energy, CSV",
         TABLE, make<MeasureExport>},
        {"bvh",
         "FILE.bvh",
         "motion of an actor's bones, BVH; of several actors a file each, FILE_NAME.bvh",
         {"a motion as BVH", {".bvh"}},
         make<BvhExport>},
        {"gltf",
         "FILE.glb",
         "the motion as one clip: actors with skeleton and mesh, other bodies as nodes, glTF 2.0 binary",
         {"a motion as glTF", {".glb"}},
         make<GltfExport>},
        {"surface",
         "FOLDER",
         "per frame: the surface of fluids as a closed mesh with normals, binary PLY",
         {},
         make<SurfaceExport>},
        {"vdb",
         "FOLDER",
         "per frame: points with id and velocity, level set of fluids, OpenVDB; where the program was built with it",
         {},
         make<VdbExport>},
        {"layers",
         "FOLDER",
         "per frame: depth, normals, albedo, ids, motion of each pixel, EXR; camera.json, annotations.json",
         {},
         make<LayerExport>},
    };
    return KINDS;
}

/// " (.csv, .txt or no ending)"; empty if the word after `=` says it all.
std::string otherEndings(const std::vector<const char*>& endings)
{
    if (endings.size() < 2) return "";
    std::string words;
    for (size_t k = 0; k < endings.size(); ++k) {
        const std::string ending = endings[k];
        words += k == 0 ? " (" : k + 1 == endings.size() ? " or " : ", ";
        words += ending.empty() ? "no ending" : ending;
    }
    return words + ")";
}

/// "ply=FOLDER, bodies=FILE.csv or gltf=FILE.glb".
std::string listOfKinds()
{
    std::vector<std::string> words;
    for (const ExportKind& kind : exportKinds()) words.push_back(fmt::format("{}={}", kind.word, kind.value));
    const std::string last = words.back();
    words.pop_back();
    return fmt::format("{} or {}", fmt::join(words, ", "), last);
}

}  // namespace

Exporters makeExporters(const std::vector<std::string>& options)
{
    std::multimap<const ExportKind*, std::unique_ptr<Exporter>> byKind;
    for (const std::string& text : options) {
        const size_t equals = text.find('=');
        const std::string path = equals == std::string::npos ? "" : text.substr(equals + 1);
        const auto kind = std::ranges::find(exportKinds(), text.substr(0, equals),
                                            [](const ExportKind& k) { return std::string(k.word); });
        if (path.empty() || kind == exportKinds().end())
            throw InputError(fmt::format("--export {}: must be {}", text, listOfKinds()));
        auto exporter = kind->make(path);
        const std::string option = fmt::format("--export {}=", kind->word);
        if (kind->place.endings.empty()) requireFolder(option, path);
        else requireEnding(option, path, kind->place.what, kind->place.endings);
        byKind.emplace(&*kind, std::move(exporter));
    }
    Exporters exporters;
    for (auto& [kind, exporter] : byKind) exporters.push_back(std::move(exporter));
    return exporters;
}

ExportNeeds needsOf(const Exporters& exporters)
{
    ExportNeeds all;
    for (const auto& exporter : exporters) {
        const ExportNeeds needs = exporter->needs();
        all.surfaces = all.surfaces || needs.surfaces;
        all.particles = all.particles || needs.particles;
        all.bodies = all.bodies || needs.bodies;
        all.measures = all.measures || needs.measures;
        all.densities = all.densities || needs.densities;
        all.views = all.views || needs.views;
    }
    return all;
}

std::string exportHelp()
{
    std::string text;
    for (const ExportKind& kind : exportKinds())
        text += fmt::format("{:<28}  {}{}\n", fmt::format("--export {}={}", kind.word, kind.value), kind.help,
                            otherEndings(kind.place.endings));
    return text;
}

}  // namespace knuckle
