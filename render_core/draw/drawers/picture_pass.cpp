#include "render_core/draw/drawers/picture_pass.hpp"

#include "render_core/draw/drawers/terrain_uniforms.hpp"
#include "render_core/draw/shader_texts.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::draw {
namespace {

// A step of the code is 3.6 % of the distance (13 octaves in 255 steps).
constexpr float kJumpBegins = 2.5f / 255.0f, kJumpFull = 6.0f / 255.0f;

/// After those of the sky.
enum PictureUniform : std::size_t {
    kScene = kSkyUniforms,
    kSceneSize,
    kOutlineColor,
    kOutline,
    kColorTable,
    kHaze,
    kUnknown,
    kLeft,
    kPictureUniforms
};
constexpr const char* kUniformNames[kPictureUniforms - kSkyUniforms] = {"scene",       "scene_size", "line_color",    "outline",
                                                                        "color_table", "haze_color", "unknown_color", "left"};

struct UniformNames {
    const char* names[kPictureUniforms];
    UniformNames() : names{} {
        for (std::size_t n = 0; n < kPictureUniforms; ++n)
            names[n] = n < kSkyUniforms ? kSkyUniformNames[n] : kUniformNames[n - kSkyUniforms];
    }
};

void set_picture_color(gl::Gl& gl, GLint location, design::Color color) {
    gl->Uniform3f(location, static_cast<float>(color.red) / 255.0f, static_cast<float>(color.green) / 255.0f,
                  static_cast<float>(color.blue) / 255.0f);
}

}  // namespace

base::Error PicturePass::start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px,
                               DrawnDesigns designs) {
    const gl::TextureSettings color{gl::TextureFormat::rgba8, gl::TextureFilter::nearest, width_px, height_px};
    auto target = gl::make_render_target(gl, *budget.find(effects::kRenderTargets), color, gl::TargetDepth::bits24);
    if (!target.ok()) return target.error();
    target_ = static_cast<gl::RenderTarget&&>(target.value());
    if (base::Error error = grid_.start(gl, budget)) return error;
    for (const DrawnDesign& drawn : designs) {
        if (drawn.output == TerrainOutput::color || shows(drawn)) continue;
        const bool coded = drawn.output == TerrainOutput::code;
        with_air_ = drawn.design->sky.air.is_shown;
        if (coded && !colors_.is_started())
            if (base::Error error = colors_.start(gl, *budget.find(effects::kRenderTargets))) return error;
        if (base::Error error = build_programs(gl, coded, drawn.design->terrain.style.sketch.silhouettes > 0)) return error;
    }
    set_design(designs[0]);
    return {};
}

bool PicturePass::shows(const DrawnDesign& design) const {
    const Programs& programs = programs_[design.output == TerrainOutput::code ? 1 : 0];
    return programs.ground[0][design.design->terrain.style.sketch.silhouettes > 0 ? 1 : 0].valid();
}

void PicturePass::set_design(const DrawnDesign& design) {
    coded_ = design.output == TerrainOutput::code;
    colors_.forget();
}

base::Error PicturePass::build_program(gl::Gl& gl, bool coded, std::string_view defines, gl::Program& program) const {
    const UniformNames uniforms;
    base::FixedString<kMaxShaderText> fragment(coded ? "#define CODED 1\n" : "");
    fragment.append(defines);
    if (with_air_) fragment.append("#define AIR 1\n");
    if (with_air_) fragment.append(shader_text(k_air_frag));
    if (with_air_) fragment.append(shader_text(k_fine_distance_frag));
    fragment.append(shader_text(k_unknown_ground_frag));
    fragment.append(shader_text(k_sky_color_frag));
    fragment.append(shader_text(k_picture_frag));
    auto built = gl::build_program(
        gl, {"picture", shader_text(k_screen_vert), fragment.view(), base::Span<const gl::AttributeBinding>(kScreenAttributes),
             base::Span<const char* const>(uniforms.names), true});
    if (!built.ok()) return built.error();
    program = built.value();
    return {};
}

/// Without silhouettes too: the time may not suffice for them.
base::Error PicturePass::build_programs(gl::Gl& gl, bool coded, bool outlined) {
    Programs& programs = programs_[coded ? 1 : 0];
    if (!programs.sky.valid())
        if (base::Error error = build_program(gl, coded, "#define SKY 1\n", programs.sky)) return error;
    for (const bool hatched : {false, true})
        for (const bool lines : {false, true}) {
            gl::Program& program = programs.ground[hatched ? 1 : 0][lines ? 1 : 0];
            if ((hatched && !coded) || (lines && !outlined) || program.valid()) continue;
            base::FixedString<40> defines(hatched ? "#define HATCHED 1\n" : "");
            if (lines) defines.append("#define OUTLINED 1\n");
            if (base::Error error = build_program(gl, coded, defines.view(), program)) return error;
        }
    return {};
}

void PicturePass::begin(gl::Gl& gl) const {
    target_.bind(gl);
    gl->ClearColor(1.0f, 1.0f, 1.0f, 1.0f);
    gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void PicturePass::finish(gl::Gl& gl, const gl::DrawPlace& place, const design::DesignSettings& design,
                         const PictureInput& input) {
    if (coded_) colors_.update(gl, design.terrain, input.heights, input.bands, input.sky.colors, input.haze_per_m, input.alert);
    place.bind(gl);
    gl->Disable(GL_DEPTH_TEST);
    gl->Disable(GL_CULL_FACE);
    gl->Disable(GL_BLEND);
    paint_ground(gl, design, input);
    use(gl, programs_[coded_ ? 1 : 0].sky, design, input);
    grid_.draw_cells(gl, input.ground, false);
}

void PicturePass::repaint(gl::Gl& gl, const design::DesignSettings& design, const PictureInput& input) {
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(GL_GREATER);  // the picture lies on the far plane
    gl->DepthMask(GL_FALSE);
    paint_ground(gl, design, input);
    gl->DepthMask(GL_TRUE);
    gl->DepthFunc(GL_LESS);
}

void PicturePass::paint_ground(gl::Gl& gl, const design::DesignSettings& design, const PictureInput& input) const {
    target_.color().bind(gl, 0);
    const gl::Program& ground = programs_[coded_ ? 1 : 0].ground[coded_ && input.has_void ? 1 : 0][input.outlined ? 1 : 0];
    use(gl, ground, design, input);
    grid_.draw_cells(gl, input.ground, true);
}

void PicturePass::use(gl::Gl& gl, const gl::Program& program, const design::DesignSettings& design,
                      const PictureInput& input) const {
    program.use(gl);
    gl->Uniform1i(program.uniform(kScene), 0);
    const gl::TextureSettings& size = target_.color().settings();
    gl->Uniform2f(program.uniform(kSceneSize), static_cast<float>(size.width_px), static_cast<float>(size.height_px));
    set_sky_uniforms(gl, program, input.sky);
    gl->Uniform2f(program.uniform(kLeft), static_cast<float>(input.left.least), static_cast<float>(input.left.most));
    if (input.outlined) set_outline(gl, program, design.terrain.style.sketch);
    if (coded_) set_colors(gl, program, design);
}

void PicturePass::set_outline(gl::Gl& gl, const gl::Program& program, const design::SketchSettings& sketch) const {
    gl->Uniform3f(program.uniform(kOutline), static_cast<float>(sketch.silhouettes), kJumpBegins, 1 / (kJumpFull - kJumpBegins));
    set_picture_color(gl, program.uniform(kOutlineColor), sketch.line);
}

void PicturePass::set_colors(gl::Gl& gl, const gl::Program& program, const design::DesignSettings& design) const {
    colors_.texture().bind(gl, 1);
    gl->Uniform1i(program.uniform(kColorTable), 1);
    set_picture_color(gl, program.uniform(kHaze), design.sky.haze);
    set_picture_color(gl, program.uniform(kUnknown), design.terrain.unknown);
}

void PicturePass::destroy(gl::Gl& gl) {
    for (Programs& programs : programs_) {
        programs.sky.destroy(gl);
        for (auto& some : programs.ground)
            for (gl::Program& program : some) program.destroy(gl);
    }
    colors_.destroy(gl);
    grid_.destroy(gl);
    target_.destroy(gl);
}

}  // namespace tedavis::draw
