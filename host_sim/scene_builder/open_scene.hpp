/// Opens a scene database on disk: it is read completely and verified as on a board.
#pragma once

#include <memory>
#include <string>

#include "render_core/scene/scene.hpp"

namespace tedavis::host_sim {

class OpenScene {
public:
    /// Throws UserError with the fault, its offset, and what to do.
    explicit OpenScene(const std::string& path);

    /// Lives as long as this object.
    [[nodiscard]] const scene::Scene& scene() const { return scene_; }

private:
    std::unique_ptr<unsigned char[]> memory_;
    scene::Scene scene_;
};

}  // namespace tedavis::host_sim
