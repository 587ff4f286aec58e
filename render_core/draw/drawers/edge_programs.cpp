#include "render_core/draw/drawers/edge_programs.hpp"

#include "render_core/base/fixed_string.hpp"
#include "render_core/draw/shader_texts.hpp"

namespace tedavis::draw {
namespace {

constexpr gl::AttributeBinding kEdgeAttributes[] = {{"position", 0}};
constexpr const char* kEdgeUniformNames[kEdgeUniforms] = {"first", "first_size", "picture",    "band",
                                                          "rows",  "bell",       "thresholds", "parts"};

/// FOLLOWED: steps within a block of 4 x 4 pixels, through which no shortest way has more than two of each 2 x 2. FULL_TINT: the
/// density that has the last colour, as in the evaluation's views.
constexpr std::string_view kEdgeConstants =
    "#define FOLLOWED 8.0\n"
    "#define FULL_TINT 0.25\n";

struct EdgeStepText {
    const char* name;
    std::string_view text;
};

/// In the order of EdgeStep.
std::array<EdgeStepText, kEdgeSteps> edge_step_texts() {
    const std::string_view show = shader_text(k_edge_show_frag);
    return {{{"edges: planes", shader_text(k_edge_planes_frag)},
             {"edges: blur", shader_text(k_edge_blur_frag)},
             {"edges: crests", shader_text(k_edge_crests_frag)},
             {"edges: follow", shader_text(k_edge_follow_frag)},
             {"edges: count", shader_text(k_edge_count_frag)},
             {"edges: regions", shader_text(k_edge_regions_frag)},
             {"edges: shown", show},
             {"edges: regions shown", show}}};
}

void define_most(base::FixedString<kMaxShaderText>& text, std::uint32_t turns) {
    text.append("#define MOST ");
    text.append(base::digits(turns).view());
    text.append("\n");
}

}  // namespace

base::Error EdgePrograms::build(gl::Gl& gl, EdgeStep step, const EdgeLoops& loops) {
    const EdgeStepText parts = edge_step_texts()[static_cast<std::size_t>(step)];
    base::FixedString<kMaxShaderText> fragment(kEdgeConstants);
    if (step == EdgeStep::count) define_most(fragment, loops.blocks);
    if (step == EdgeStep::regions) define_most(fragment, loops.counts);
    fragment.append(shader_text(k_edge_codes_frag));
    if (step == EdgeStep::show_regions) {
        fragment.append("#define REGIONS 1\n");
        fragment.append(shader_text(k_heat_frag));
    }
    fragment.append(parts.text);
    auto built = gl::build_program(
        gl, {parts.name, shader_text(k_saliency_vert), fragment.view(), base::Span<const gl::AttributeBinding>(kEdgeAttributes),
             base::Span<const char* const>(kEdgeUniformNames), true});
    if (!built.ok()) return built.error();
    programs_[static_cast<std::size_t>(step)] = built.value();
    return {};
}

base::Error EdgePrograms::start(gl::Gl& gl, const EdgeLoops& loops, bool shows) {
    for (std::size_t n = 0; n < kEdgeSteps; ++n) {
        const auto step = static_cast<EdgeStep>(n);
        if (!shows && (step == EdgeStep::show_edges || step == EdgeStep::show_regions)) continue;
        if (base::Error error = build(gl, step, loops)) return error;
    }
    return {};
}

const gl::Program& EdgePrograms::use(gl::Gl& gl, EdgeStep step, const gl::Texture& texture, std::uint32_t width_px,
                                     std::uint32_t height_px) const {
    const gl::Program& program = programs_[static_cast<std::size_t>(step)];
    program.use(gl);
    texture.bind(gl, 0);
    gl->Uniform1i(program.uniform(kEdgeTexture), 0);
    gl->Uniform2f(program.uniform(kEdgeTextureSize), static_cast<float>(texture.settings().width_px),
                  static_cast<float>(texture.settings().height_px));
    gl->Uniform2f(program.uniform(kEdgePicture), static_cast<float>(width_px), static_cast<float>(height_px));
    return program;
}

void EdgePrograms::destroy(gl::Gl& gl) {
    for (gl::Program& program : programs_) program.destroy(gl);
}

}  // namespace tedavis::draw
