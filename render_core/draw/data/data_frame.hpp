/// What a frame gives all drawers of spatial data: the eye, light and haze, as uniforms that their programs share
/// (shaders/data_light.vert, shaders/data_color.frag).
///
/// Plain data. Thread  the GL thread for the functions.
#pragma once

#include <glm/vec3.hpp>

#include "render_core/base/fixed_string.hpp"
#include "render_core/design/color.hpp"
#include "render_core/draw/air_table.hpp"
#include "render_core/draw/data/data_grid.hpp"
#include "render_core/draw/depth_plan.hpp"
#include "render_core/draw/shader_texts.hpp"
#include "render_core/draw/view_effects_pass.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::draw {

struct DataFrame {
    terrain::View view;
    glm::dvec3 towards_light{0, 0, 1};  ///< unit vector in ECEF
    double ambient = 0.6;               ///< 0..1: what a side turned away from the light keeps of its colour
    double haze_per_m = 0;              ///< 1 / distance at which haze hides 1 - 1/e; 0 for none
    design::Color haze;
    AirFrame air;
    DistanceLeft left;                 ///< in the picture's alpha, by what is opaque
    DataGrid grid;                     ///< on what asks for it
    bool without_uncertainty = false;  ///< no glyphs that say nothing else
};

/// What frames may have; for what they have not nothing is compiled.
struct DataVariant {
    bool air = false, grid = false, shadows = false, magnified = false;
};

/// Every program of data begins its list of uniforms with these.
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

/// The program text that colours data: behind air where frames may have some, else behind haze; after the caller's own defines.
using DataFragment = base::FixedString<kMaxShaderText>;
void add_data_fragment(DataFragment& text, bool with_air);

/// Whether what is drawn next hides all behind it; of the program in use, after set_data_frame().
void set_opaque(gl::Gl& gl, const gl::Program& program, const DataFrame& frame, bool is_opaque);
/// Of the program in use; places relative to the eye. What is drawn next is mixed.
void set_data_frame(gl::Gl& gl, const gl::Program& program, const DataFrame& frame, const DepthRange& range);

}  // namespace tedavis::draw
