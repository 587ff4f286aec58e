/// A scene in memory, as a display has it, from a draft.
#pragma once

#include <gtest/gtest.h>

#include "render_core/scene/scene.hpp"
#include "tests/support/files/flaky_bytes.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::test_support {

class LoadedScene {
public:
    explicit LoadedScene(const host_sim::SceneDraft& draft) {
        FlakyBytes source(host_sim::sdb_bytes(draft));
        memory_.resize(source.content.size() * 2 + 65536);
        base::Arena arena(memory_.data(), memory_.size());
        auto loaded = scene::Scene::load(source, arena);
        EXPECT_TRUE(loaded.ok()) << scene::describe(loaded.error()).view();
        scene_ = loaded.value();
    }
    explicit LoadedScene(const host_sim::LayerDraft& layer) : LoadedScene(host_sim::SceneDraft{"one", "a test", 1, {layer}}) {}

    [[nodiscard]] const scene::Scene& scene() const { return scene_; }
    [[nodiscard]] const scene::Layer& layer() const { return scene_.layers()[0]; }
    [[nodiscard]] const scene::Attribute& attribute() const { return layer().attributes[0]; }

private:
    std::vector<std::uint8_t> memory_;
    scene::Scene scene_;
};

}  // namespace tedavis::test_support
