#include "render_core/draw/drawers/data/data_frame.hpp"

#include "render_core/draw/drawers/view_projection.hpp"

namespace tedavis::draw {

void add_data_fragment(DataFragment& text, bool with_air) {
    if (with_air) {
        text.append("#define AIR 1\n");
        text.append(shader_text(k_air_frag));
    }
    text.append(shader_text(k_data_color_frag));
}

void set_opaque(gl::Gl& gl, const gl::Program& program, const DataFrame& frame, bool is_opaque) {
    gl->Uniform3f(program.uniform(kDataLeft), static_cast<float>(frame.left.least), static_cast<float>(frame.left.most),
                  is_opaque && frame.left.is_left() ? 1.0f : 0.0f);
}

void set_data_frame(gl::Gl& gl, const gl::Program& program, const DataFrame& frame, const DepthRange& range) {
    set_matrix(gl, program.uniform(kDataViewProjection), view_projection(frame.view, range));
    const glm::vec3 light(frame.towards_light);
    gl->Uniform4f(program.uniform(kDataLight), light.x, light.y, light.z, static_cast<float>(frame.ambient));
    gl->Uniform1f(program.uniform(kDataHazePerM), static_cast<float>(frame.haze_per_m));
    constexpr float kFull = 255;
    gl->Uniform3f(program.uniform(kDataHaze), static_cast<float>(frame.haze.red) / kFull,
                  static_cast<float>(frame.haze.green) / kFull, static_cast<float>(frame.haze.blue) / kFull);
    set_opaque(gl, program, frame, false);
    if (program.uniform(kDataAir) >= 0) set_air_uniforms(gl, program, kDataAir, frame.air);
}

}  // namespace tedavis::draw
