#pragma once

#include <cstdint>

#include "app/json/json.h"

namespace knuckle {

struct SceneEntry;

/// Most particles of a scene.
inline constexpr uint64_t MAX_PARTICLES = 1'000'000;

/// Refuses an object that would bring the scene above MAX_PARTICLES, before anything large is allocated.
/// @param count particles of one copy. @throws InputError.
void limitParticles(const SceneEntry& object, double count);

/// The same for `count` more particles. @param field of the entry. @param remedy for the error message.
void limitTotal(const SceneEntry& entry, const char* field, double count, const char* remedy);

}  // namespace knuckle
