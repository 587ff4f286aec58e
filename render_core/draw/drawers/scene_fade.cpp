#include "render_core/draw/drawers/scene_fade.hpp"

namespace tedavis::draw {

void SceneFade::draw(gl::Gl& gl, double share) const {
    gl->Enable(GL_BLEND);
    gl->BlendColor(0, 0, 0, static_cast<float>(share));
    gl->BlendFuncSeparate(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA, GL_ZERO, GL_ONE);
    picture_.draw(gl);
    gl->Disable(GL_BLEND);
}

}  // namespace tedavis::draw
