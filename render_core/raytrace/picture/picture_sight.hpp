/// From where a picture is seen, and in which space its rays are straight: in grid space, or in the world over a terrain
/// database.
#pragma once

#include "render_core/raytrace/space/trace_ground.hpp"

namespace tedavis::raytrace {

struct PictureSight {
    /// Of the scene's grid space. Where the world is seen it is what rays are near the eye, t being the depth in metres.
    GridCamera camera;
    GroundSpace space;   ///< not set: rays are straight in grid space
    terrain::View view;  ///< of the world

    [[nodiscard]] bool is_of_world() const { return space.is_set(); }

    [[nodiscard]] static PictureSight of_grid(const GridCamera& camera) {
        PictureSight sight;
        sight.camera = camera;
        return sight;
    }
    /// can_trace() must hold. The space borrows its database.
    [[nodiscard]] static PictureSight of_world(const GroundSpace& space, const terrain::View& view) {
        constexpr double kNear_m = 200;
        PictureSight sight;
        sight.camera = fit_camera(space, view, {0, 0, view.width, view.height}, 0, kNear_m);
        sight.space = space;
        sight.view = view;
        return sight;
    }
    /// Of a grid with so many posts to one of this.
    [[nodiscard]] PictureSight refined(std::uint32_t parts) const {
        const auto many = static_cast<double>(parts);
        const glm::dvec3 finer(many, many, 1);
        PictureSight sight = *this;
        sight.camera = {camera.origin * finer, camera.corner * glm::vec3(finer), camera.right * glm::vec3(finer),
                        camera.down * glm::vec3(finer)};
        if (is_of_world()) sight.space = space.refined(parts);
        return sight;
    }
};

}  // namespace tedavis::raytrace
