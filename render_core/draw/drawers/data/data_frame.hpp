/// The frame's data for all drawers of spatial data: eye point, light and haze, as uniforms that their programs share
/// (shaders/data_light.vert, shaders/data_color.frag).
///
/// Plain data. Thread  the GL thread for the functions.
#pragma once

#include <glm/vec3.hpp>

#include "render_core/base/fixed_string.hpp"
#include "render_core/design/color.hpp"
#include "render_core/draw/data/data_variant.hpp"
#include "render_core/draw/depth_plan.hpp"
#include "render_core/draw/drawers/air_table.hpp"
#include "render_core/draw/drawers/data/data_grid.hpp"
#include "render_core/draw/drawers/view_effects_pass.hpp"
#include "render_core/draw/shader_texts.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::draw {

struct DataFrame {
    terrain::View view;
    glm::dvec3 towards_light{0, 0, 1};  ///< unit vector in ECEF
    double ambient = 0.6;               ///< 0..1, brightness of a side that faces away from the light
    double haze_per_m = 0;              ///< 1 / distance at which haze hides 1 - 1/e; 0 for none
    design::Color haze;
    AirFrame air;
    DistanceLeft left;                 ///< what opaque objects write to the picture's alpha
    DataGrid grid;                     ///< on elements that request it
    bool without_uncertainty = false;  ///< glyphs that only show uncertainty are left out
};

/// The first uniforms of every program for data.
enum DataUniform : std::size_t {
    kDataViewProjection,
    kDataLight,
    kDataHazePerM,
    kDataHaze,
    kDataLeft,
    kDataAir,  ///< the first of kAirUniformNames
    kFirstOwnDataUniform = kDataAir + kAirUniforms
};
inline constexpr const char* kDataUniformNames[kFirstOwnDataUniform] = {"view_projection",
                                                                        "light",
                                                                        "haze_per_m",
                                                                        "haze_color",
                                                                        "left",
                                                                        kAirUniformNames[0],
                                                                        kAirUniformNames[1],
                                                                        kAirUniformNames[2],
                                                                        kAirUniformNames[3]};

/// The text of the program that colours data, with scattering air where frames may have it, else with haze; it follows the
/// caller's defines.
using DataFragment = base::FixedString<kMaxShaderText>;
void add_data_fragment(DataFragment& text, bool with_air);

/// Sets whether what is drawn next is opaque; for the program in use, after set_data_frame().
void set_opaque(gl::Gl& gl, const gl::Program& program, const DataFrame& frame, bool is_opaque);
/// Sets the uniforms of the program in use; positions are relative to the eye point. What is drawn next is blended.
void set_data_frame(gl::Gl& gl, const gl::Program& program, const DataFrame& frame, const DepthRange& range);

}  // namespace tedavis::draw
