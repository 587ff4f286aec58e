#include "render_core/draw/drawers/saliency_programs.hpp"

#include "render_core/base/fixed_string.hpp"
#include "render_core/draw/shader_texts.hpp"

namespace tedavis::draw {
namespace {

constexpr gl::AttributeBinding kSaliencyAttributes[] = {{"position", 0}};
constexpr const char* kSaliencyUniformNames[kSaliencyUniforms] = {
    "first",       "second",       "third", "fourth",       "figures",     "first_size", "second_size", "third_size",
    "fourth_size", "figures_size", "strip", "share",        "has_coarser", "origin",     "column",      "scale",
    "bell",        "cosine",       "sine",  "slant_cosine", "slant_sine",  "flat_share"};

/// Of rows under waves, so that they fill the range of their codes; what codes round off.
constexpr std::string_view kConstants =
    "#define ROW_GAIN 2.4\n"
    "#define LEAST_AMPLITUDE 2e-4\n";

struct StepText {
    const char* name;
    std::string_view define, text;
    bool reads_between = false, weighs = false;
};

/// In the order of SaliencyStep.
std::array<StepText, kSaliencySteps> step_texts() {
    const std::string_view contrast = shader_text(k_saliency_contrast_frag), extent = shader_text(k_saliency_extent_frag),
                           mix = shader_text(k_saliency_mix_frag), show = shader_text(k_saliency_show_frag);
    return {{{"saliency: colours", "", shader_text(k_saliency_lab_frag)},
             {"saliency: softened colours", "", shader_text(k_saliency_soften_frag), true},
             {"saliency: levels", "", shader_text(k_saliency_reduce_frag), true},
             {"saliency: rows", "", shader_text(k_saliency_rows_frag), true},
             {"saliency: directions", "", shader_text(k_saliency_energy_frag), true},
             {"saliency: contrast of colours", "#define COLORS 1\n", contrast, true},
             {"saliency: contrast of blue", "#define BLUE 1\n", contrast, true},
             {"saliency: contrast of directions", "#define ENERGY 1\n", contrast, true},
             {"saliency: maximum", "#define MOST 1\n", extent},
             {"saliency: count", "#define COUNT 1\n", extent, false, true},
             {"saliency: sum of counts", "#define SUM 1\n", extent},
             {"saliency: conspicuity", "#define CONSPICUITY 1\n", mix, false, true},
             {"saliency: total", "#define TOTAL 1\n", mix, false, true},
             {"saliency: maximum of total", "#define WIDE 1\n", extent},
             {"saliency: map", "#define MAP 1\n", mix, false, true},
             {"saliency: shown", "", show},
             {"saliency: heat", "#define HEAT 1\n", show}}};
}

}  // namespace

base::Error SaliencyPrograms::build(gl::Gl& gl, SaliencyStep step, int level) {
    const StepText parts = step_texts()[static_cast<std::size_t>(step)];
    constexpr std::string_view kBlocks[] = {"#define BLOCK 1\n", "#define BLOCK 2\n", "#define BLOCK 4\n", "#define BLOCK 8\n"};
    base::FixedString<kMaxShaderText> fragment(parts.define);
    fragment.append(kConstants);
    fragment.append(kBlocks[level]);
    fragment.append(shader_text(k_saliency_codes_frag));
    if (parts.reads_between) fragment.append(shader_text(k_saliency_between_frag));
    if (parts.weighs) fragment.append(shader_text(k_saliency_weights_frag));
    if (step == SaliencyStep::show_heat) fragment.append(shader_text(k_heat_frag));
    fragment.append(parts.text);
    auto built = gl::build_program(gl, {parts.name, shader_text(k_saliency_vert), fragment.view(),
                                        base::Span<const gl::AttributeBinding>(kSaliencyAttributes),
                                        base::Span<const char* const>(kSaliencyUniformNames), true});
    if (!built.ok()) return built.error();
    programs_[static_cast<std::size_t>(step)] = built.value();
    return {};
}

base::Error SaliencyPrograms::start(gl::Gl& gl, int level, bool shows_map, bool shows_heat) {
    for (std::size_t n = 0; n < kSaliencySteps; ++n) {
        const auto step = static_cast<SaliencyStep>(n);
        if ((step == SaliencyStep::show_map && !shows_map) || (step == SaliencyStep::show_heat && !shows_heat)) continue;
        if (base::Error error = build(gl, step, level)) return error;
    }
    return {};
}

const gl::Program& SaliencyPrograms::use(gl::Gl& gl, SaliencyStep step) const {
    const gl::Program& program = programs_[static_cast<std::size_t>(step)];
    program.use(gl);
    return program;
}

void SaliencyPrograms::destroy(gl::Gl& gl) {
    for (gl::Program& program : programs_) program.destroy(gl);
}

void read_texture(gl::Gl& gl, const gl::Program& program, SaliencyUniform place, const gl::Texture& texture) {
    texture.bind(gl, place);
    gl->Uniform1i(program.uniform(place), static_cast<GLint>(place));
    gl->Uniform2f(program.uniform(kSaliencySizes + place), static_cast<float>(texture.settings().width_px),
                  static_cast<float>(texture.settings().height_px));
}

}  // namespace tedavis::draw
