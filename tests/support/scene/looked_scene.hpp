/// Builds a scene of the layer that `tedavis scene look` prints for a file: the proof that it can be used as it is.
#pragma once

#include <string>

#include "host_sim/scene_builder/scene_build.hpp"
#include "host_sim/scene_builder/sdb_writer.hpp"
#include "host_sim/scene_builder/source_look.hpp"

namespace tedavis::test_support {

inline host_sim::LayerDraft built_layer(const host_sim::SourceLook& look) {
    const host_sim::SceneRecipe recipe = host_sim::parse_scene("name = \"my_scene\"\n" + look.layer, "scene.toml");
    host_sim::MadeScene made = host_sim::make_scene(recipe, "", [](std::string_view, std::size_t, std::size_t) {});
    (void)host_sim::sdb_bytes(made.draft);
    return std::move(made.draft.layers.at(0));
}

}  // namespace tedavis::test_support
