#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/json/json.h"
#include "sim/rig/actor.h"
#include "sim/rig/import/imports.h"

namespace knuckle {

/// Files that a scene reads: models, and actors that are made of them or read, each once for all objects that need the
/// same.
class SceneFiles {
public:
    /// @param scene path of its file, in whose folder other files are searched.
    /// @param limited whether the solver supports limits of joints.
    SceneFiles(std::string scene, bool limited) : scene_(std::move(scene)), limited_(limited) {}

    /// A path in the scene, relative to the program's working folder; that of findAsset() if there is nothing, and it
    /// begins with `assets/`.
    std::string beside(const std::string& file) const;
    /// The same, noted as read. @throws InputError with `pointer` if there is no such file.
    std::string existing(const std::string& file, const std::string& pointer);

    /// Makes a model be read with its looks, whoever needs it first. @param file of the scene.
    void expectDrawn(const std::string& file) { drawn_.insert(beside(file)); }
    /// The part of a model file that an object needs: one skeleton for an actor, everything for other objects.
    /// @param clips whether its clips are needed. @throws InputError as importModel().
    std::shared_ptr<const Model> model(const Json& object, const std::string& path, bool clips);
    /// The same for a model that an actor was made of, or that has clips for it.
    std::shared_ptr<const Model> model(const ModelSource& source, bool clips);

    /// The model that an actor was made of, with its looks.
    std::shared_ptr<const Model> drawnModel(const ModelSource& source) const;

    /// The actor of an object of type `actor`, or of the shape `mesh`. @param pointer JSON path of the object.
    /// @param diameter of its particles [m]; 0: that of its actor file, or one that fits its model.
    /// @throws InputError.
    const Actor& actor(const Json& object, const std::string& pointer, float diameter);
    /// A key that is the same for objects with equal actors.
    std::string actorKey(const Json& object, float diameter) const;

    /// All files read, without those that models name.
    const std::vector<std::string>& read() const { return read_; }
    std::shared_ptr<Imports> imports() const { return imports_; }

private:
    bool isLimited(const Json& object) const { return limited_ && object.value("limits", false); }
    Actor load(const Json& object, const std::string& path, const std::string& pointer, float diameter) const;
    Actor voxelize(const Json& object, const std::string& path, const std::string& pointer, float diameter);

    std::string scene_;
    bool limited_;
    std::set<std::string> drawn_;
    std::vector<std::string> read_;
    std::map<std::string, Actor> actors_;  ///< By their keys.
    std::shared_ptr<Imports> imports_ = std::make_shared<Imports>();
};

/// Whether an object is drawn by its mesh.
bool showsSkin(const Json& object);

}  // namespace knuckle
