/// What a frame gives all drawers of spatial data: the eye, light and haze, as uniforms that their programs share
/// (shaders/data_light.vert, shaders/data_color.frag).
///
/// Plain data. Thread  the GL thread for the functions.
#pragma once

#include <glm/vec3.hpp>

#include "render_core/design/color.hpp"
#include "render_core/draw/depth_plan.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::draw {

struct DataFrame {
    terrain::View view;
    glm::dvec3 towards_light{0, 0, 1};  ///< unit vector in ECEF
    double ambient = 0.6;               ///< 0..1: what a side turned away from the light keeps of its colour
    double haze_per_m = 0;              ///< 1 / distance at which haze hides 1 - 1/e; 0 for none
    design::Color haze;
};

/// Every program of data begins its list of uniforms with these.
enum DataUniform : std::size_t { kDataViewProjection, kDataLight, kDataHazePerM, kDataHaze, kFirstOwnDataUniform };
inline constexpr const char* kDataUniformNames[kFirstOwnDataUniform] = {"view_projection", "light", "haze_per_m", "haze_color"};

/// Of the program in use; places relative to the eye.
void set_data_frame(gl::Gl& gl, const gl::Program& program, const DataFrame& frame, const DepthRange& range);

}  // namespace tedavis::draw
