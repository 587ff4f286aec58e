/// What each effect adds to a frame of 1024 x 768 on the processor's own OpenGL, over the shipped terrain and scene, as
/// `tedavis calibrate` measures it: frames with and without it in turn. Beside it a bare pass over the whole picture with as many
/// texture reads, of the same kind, as the effect's own pass has; nothing that works by pixels can cost less. `--json` prints the
/// lines as a list.
#include <cstdio>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "host_sim/commands/own_ground.hpp"
#include "host_sim/measure/paired_cost.hpp"
#include "host_sim/replay/desk_bench.hpp"
#include "host_sim/temporary_folder.hpp"
#include "platform/clock/monotonic_clock.hpp"
#include "render_core/base/utc_time.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/support/draw/screen_triangle.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace {

using namespace tedavis;
using bench::BenchResult;
using effects::Effect;

constexpr std::uint32_t kWidth = 1024, kHeight = 768, kRounds = 15;
constexpr double kNoTarget = std::numeric_limits<double>::max();

/// What a tap reads: a texel as it is of a picture, or half floats between four texels of a table.
enum class Tap : std::uint8_t { texel, table };

struct PixelEffect {
    Effect effect;
    int taps;            ///< of its pass, those of a smaller one by its share of the picture; 0: it only writes
    double most_passes;  ///< bare passes that it may cost
    Tap tap = Tap::texel;
};
constexpr PixelEffect kPixelEffects[] = {{Effect::silhouettes, 5, kNoTarget},  {Effect::aerial_perspective, 3, 2, Tap::table},
                                         {Effect::haze, 0, kNoTarget},         {Effect::depth_of_field, 17, kNoTarget},
                                         {Effect::antialiasing, 5, kNoTarget}, {Effect::panel_lighting, 0, kNoTarget},
                                         {Effect::surface_grid, 0, kNoTarget}, {Effect::soft_shadows, 10, kNoTarget},
                                         {Effect::volumetric_light, 10, 4},    {Effect::stereo, 1, kNoTarget},
                                         {Effect::saliency, 17, kNoTarget}};

/// Milliseconds of a pass that reads so many texels round every pixel.
double bare_pass_ms(int taps, Tap tap) {
    test_support::GlSession session("egl", "desktop", kWidth, kHeight);
    gl::Gl& gl = session.gl;
    std::string fragment = "uniform sampler2D image;\nvoid main() {\n    vec4 sum = vec4(0.1);\n";
    for (int n = 0; n < taps; ++n)
        fragment += tap == Tap::table
                        ? "    sum += TEXTURE2D(image, gl_FragCoord.yx / 1024.0 + vec2(0.0, " + std::to_string(n / 4.0) + "));\n"
                        : "    sum += texelFetch(image, ivec2(gl_FragCoord.xy) + ivec2(" + std::to_string(n % 5) + ", " +
                              std::to_string(n / 5) + "), 0);\n";
    if (taps == 0) fragment = "uniform vec4 image;\nvoid main() {\n    vec4 sum = image;\n";
    fragment += "    FRAGMENT_COLOR = 0.1 * sum;\n}\n";
    test_support::ScreenTriangle triangle(gl, fragment);
    base::BudgetLine line;
    line.bytes = std::uint64_t{kWidth} * kHeight * 4;
    const gl::TextureSettings settings =
        tap == Tap::table ? gl::TextureSettings{gl::TextureFormat::rgba16f, gl::TextureFilter::linear, 64, 192}
                          : gl::TextureSettings{gl::TextureFormat::rgba8, gl::TextureFilter::nearest, kWidth, kHeight};
    auto picture = gl::make_texture(gl, line, settings);
    const std::vector<std::uint8_t> grey(line.bytes, 50);  // of half floats about a tenth
    static_cast<void>(picture.value().upload(gl, {0, 0, settings.width_px, settings.height_px}, grey.data()));
    triangle.program().use(gl);
    if (taps > 0) {
        picture.value().bind(gl, 0);
        gl->Uniform1i(triangle.program().uniform(0), 0);
    }
    std::vector<double> with, without;
    for (std::uint32_t n = 0; n < kRounds + 2; ++n)
        for (const bool draws : {false, true}) {
            const base::Time start = platform::monotonic_now();
            gl->Clear(GL_COLOR_BUFFER_BIT);
            if (draws) triangle.draw(gl);
            gl->Finish();
            if (n >= 2) (draws ? with : without).push_back((platform::monotonic_now() - start).to_seconds() * 1000);
        }
    picture.value().destroy(gl);
    triangle.destroy(gl);
    return host_sim::paired_cost(with, without).ms;
}

effects::MeasuredCosts measured(const std::string& folder, host_sim::Console& console) {
    host_sim::PictureOptions picture;
    picture.device = "desktop";
    picture.size = host_sim::PictureSize{kWidth, kHeight};
    host_sim::use_own_ground(picture, folder, console);
    host_sim::AircraftPose pose{36.64, -84.36, 2100, 140, -14, 0};
    static_cast<void>(base::parse_utc("2026-06-01T14:02:00Z", pose.time));
    host_sim::DeskBench bench(
        picture, {[](std::size_t done, std::size_t total) { std::fprintf(stderr, "\r%zu of %zu", done, total); }, {}});
    return bench.measure(pose, kRounds);
}

const PixelEffect* pixel_effect(std::string_view name) {
    for (const PixelEffect& known : kPixelEffects)
        if (effects::row_of(known.effect).name == name) return &known;
    return nullptr;
}

}  // namespace

int main(int argc, char** argv) {
    const bool json = argc == 2 && std::strcmp(argv[1], "--json") == 0;
    if (argc > 1 && !json) {
        std::fprintf(stderr, "bench_effects: unknown argument '%s'; only --json is known\n", argv[1]);
        return 2;
    }
    const host_sim::TemporaryFolder folder;
    std::ostringstream results, notes;
    host_sim::Console console(results, notes, false, false);
    std::vector<BenchResult> lines;
    const effects::MeasuredCosts costs = measured(folder.path(), console);
    for (const effects::MeasuredCost& cost : costs.costs) {
        if (!cost.note.empty()) continue;
        const PixelEffect* const known = pixel_effect(cost.name.view());
        const double bare_ms = known == nullptr ? 0 : bare_pass_ms(known->taps, known->tap);
        const bool has_target = known != nullptr && known->most_passes < kNoTarget;
        const double target_ms = has_target ? known->most_passes * bare_ms : 0;
        lines.push_back({std::string(cost.name.view()), cost.ms, "ms", target_ms, !has_target || cost.ms <= target_ms, bare_ms});
        lines.push_back({std::string(cost.name.view()) + ": half of its spread", cost.spread_ms, "ms", 0, true, 0});
    }
    std::fprintf(stderr, "\n");
    return bench::report(lines, json);
}
