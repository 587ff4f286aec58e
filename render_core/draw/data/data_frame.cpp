#include "render_core/draw/data/data_frame.hpp"

#include "render_core/draw/view_projection.hpp"

namespace tedavis::draw {

void set_data_frame(gl::Gl& gl, const gl::Program& program, const DataFrame& frame, const DepthRange& range) {
    set_matrix(gl, program.uniform(kDataViewProjection), view_projection(frame.view, range));
    const glm::vec3 light(frame.towards_light);
    gl->Uniform4f(program.uniform(kDataLight), light.x, light.y, light.z, static_cast<float>(frame.ambient));
    gl->Uniform1f(program.uniform(kDataHazePerM), static_cast<float>(frame.haze_per_m));
    constexpr float kFull = 255;
    gl->Uniform3f(program.uniform(kDataHaze), static_cast<float>(frame.haze.red) / kFull,
                  static_cast<float>(frame.haze.green) / kFull, static_cast<float>(frame.haze.blue) / kFull);
}

}  // namespace tedavis::draw
