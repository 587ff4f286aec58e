#include "render_core/draw/drawers/dimmer.hpp"

#include "render_core/draw/shader_texts.hpp"

namespace tedavis::draw {

base::Error Dimmer::start(gl::Gl& gl, base::BudgetTable& budget) {
    static constexpr const char* kNames[] = {"white"};
    if (base::Error error = grid_.start(gl, budget)) return error;
    auto built =
        gl::build_program(gl, {"dimmer", shader_text(k_screen_vert), shader_text(k_dim_frag),
                               base::Span<const gl::AttributeBinding>(kScreenAttributes), base::Span<const char* const>(kNames)});
    if (!built.ok()) return built.error();
    program_ = built.value();
    return {};
}

void Dimmer::draw(gl::Gl& gl, const glm::dvec3& white) const {
    gl->Disable(GL_DEPTH_TEST);
    gl->Disable(GL_CULL_FACE);
    gl->Enable(GL_BLEND);
    gl->BlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
    program_.use(gl);
    gl->Uniform3f(program_.uniform(0), static_cast<float>(white.x), static_cast<float>(white.y), static_cast<float>(white.z));
    grid_.draw(gl);
    gl->Disable(GL_BLEND);
}

void Dimmer::destroy(gl::Gl& gl) {
    program_.destroy(gl);
    grid_.destroy(gl);
}

}  // namespace tedavis::draw
