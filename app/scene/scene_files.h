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

/// What a scene reads beside itself: models, and the actors that are made of them or read, each once for all objects
/// that ask for the same.
class SceneFiles {
public:
    /// @param scene path of its file, in whose folder others are looked for.
    /// @param limited whether the solver knows limits of joints.
    SceneFiles(std::string scene, bool limited) : scene_(std::move(scene)), limited_(limited) {}

    /// A path of the scene, from where the program runs.
    std::string beside(const std::string& file) const;
    /// The same, noted as read. @throws InputError with `pointer` where there is no such file.
    std::string existing(const std::string& file, const std::string& pointer);

    /// Has the looks of a model read as well, whoever asks for it first. @param file of the scene.
    void expectDrawn(const std::string& file) { drawn_.insert(beside(file)); }
    /// The model in a file as an object wants it: an actor one skeleton of it, anything else all that there is.
    /// @param clips whether it is wanted with its clips. @throws InputError as importModel().
    std::shared_ptr<const Model> model(const Json& object, const std::string& path, bool clips);
    /// The same of a model that an actor was made of, or that has clips for it.
    std::shared_ptr<const Model> model(const ModelSource& source, bool clips);

    /// The model that an actor was made of, with how it looks.
    std::shared_ptr<const Model> drawnModel(const ModelSource& source) const;

    /// The actor of an object of type `actor`, or of the shape `mesh`. @param pointer JSON path of the object.
    /// @param diameter of its particles [m]; 0: what its actor file has, or what fits its model.
    /// @throws InputError.
    const Actor& actor(const Json& object, const std::string& pointer, float diameter);
    /// By what the actor of an object differs from others.
    std::string actorKey(const Json& object, float diameter) const;

    /// All that were read, without those that models name.
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

/// Whether an object is to be drawn by its mesh.
bool showsSkin(const Json& object);

}  // namespace knuckle
