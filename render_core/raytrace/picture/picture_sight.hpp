/// The view of a picture, and the space in which its rays are straight: grid space, or the world over a terrain database.
#pragma once

#include "render_core/raytrace/space/trace_ground.hpp"

namespace tedavis::raytrace {

struct PictureSight {
    /// The camera in the scene's grid space. For a view of the world it approximates the rays near the eye point, with t as the
    /// depth in metres.
    GridCamera camera;
    GroundSpace space;   ///< not set: rays are straight in grid space
    terrain::View view;  ///< of the world

    [[nodiscard]] bool is_of_world() const { return space.is_set(); }

    [[nodiscard]] static PictureSight of_grid(const GridCamera& camera) {
        PictureSight sight;
        sight.camera = camera;
        return sight;
    }
    /// can_trace() must hold. The database must outlive the space.
    [[nodiscard]] static PictureSight of_world(const GroundSpace& space, const terrain::View& view) {
        constexpr double kNear_m = 200;
        PictureSight sight;
        sight.camera = fit_camera(space, view, {0, 0, view.width, view.height}, 0, kNear_m);
        sight.space = space;
        sight.view = view;
        return sight;
    }
    /// Returns the same view in a grid with `parts` posts per post.
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
