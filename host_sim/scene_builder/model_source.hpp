/// Reads a 3D model for a layer of meshes: glTF 2.0 (.gltf, .glb) by the library Assimp.
///
/// Its meshes are one, with the transformations of their nodes; colours are those of vertices and materials, without textures.
/// glTF's axes (y up, the front towards z) become right, ahead and up; its metres stay.
#pragma once

#include <string>

#include "host_sim/scene_builder/scene_draft.hpp"

namespace tedavis::host_sim {

/// Vertices and triangles that the board draws of a model.
inline constexpr std::size_t kMaxModelVertices = 4096, kMaxModelTriangles = 4096;

/// Throws UserError with the path: no model, nothing in it, numbers that are none, or too much.
[[nodiscard]] ModelDraft read_model(const std::string& path);

}  // namespace tedavis::host_sim
