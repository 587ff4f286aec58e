/// Reads a 3D model for a layer of meshes: glTF 2.0 (.gltf, .glb) by the library Assimp.
///
/// Its meshes are merged, with the transformations of their nodes; colours are those of vertices and materials, without textures.
/// glTF's axes (y up, the front towards z) become right, ahead and up; its metres stay.
#pragma once

#include <string>

#include "host_sim/scene_builder/scene_draft.hpp"

namespace tedavis::host_sim {

/// Largest numbers of vertices and triangles of a model on a board.
inline constexpr std::size_t kMaxModelVertices = 4096, kMaxModelTriangles = 4096;

/// Throws UserError with the path where the file is no model, is empty, contains NaN, or has too many vertices or triangles.
[[nodiscard]] ModelDraft read_model(const std::string& path);

}  // namespace tedavis::host_sim
