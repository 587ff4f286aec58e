#include "render_core/draw/drawers/saliency_programs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "render_core/draw/shader_texts.hpp"
#include "tests/support/draw/screen_triangle.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_saliency_programs {
namespace {

using test_support::GlSession;

constexpr std::uint32_t kSide = 64;

/// What a fragment writes; it sees the codes of saliency and `uv`.
std::vector<std::uint8_t> written(const std::string& device, const std::string& main) {
    GlSession session("egl", device, kSide, kSide);
    test_support::ScreenTriangle triangle(session.gl, std::string(shader_text(k_saliency_codes_frag)) + main, {});
    triangle.program().use(session.gl);
    triangle.draw(session.gl);
    std::vector<std::uint8_t> bytes = session.pixels();
    triangle.destroy(session.gl);
    return bytes;
}

TEST(SaliencyPrograms, ThreeNumbersInATexelAreWhatTheyWere) {
    for (const char* device : {"es3-mid", "es2-small"}) {
        const auto bytes =
            written(device, "void main() { FRAGMENT_COLOR = triple_code(vec3(uv.x, 2.0 * uv.y - 1.0, uv.x - uv.y)); }\n");
        for (std::uint32_t y = 0; y < kSide; ++y)
            for (std::uint32_t x = 0; x < kSide; ++x) {
                const std::uint8_t* const n = bytes.data() + (std::size_t{y} * kSide + x) * 4;
                const double u = (x + 0.5) / kSide, v = (y + 0.5) / kSide;
                EXPECT_NEAR((n[0] * 16 + n[1] / 16) / 4095.0, u, 0.6 / 4095);
                EXPECT_NEAR((n[1] % 16 * 64 + n[2] / 4 - 512) / 470.0, 2 * v - 1, 0.6 / 470);
                EXPECT_NEAR((n[2] % 4 * 256 + n[3] - 512) / 470.0, u - v, 0.6 / 470);
            }
        const auto difference = written(device,
                                        "void main() {\n    vec3 value = vec3(uv.x, 2.0 * uv.y - 1.0, uv.x - uv.y);\n"
                                        "    vec3 again = triple_of(triple_code(value));\n"
                                        "    FRAGMENT_COLOR = vec4(abs(again - value) * 200.0, 1.0);\n}\n");
        for (std::size_t n = 0; n < difference.size(); n += 4) {
            ASSERT_LE(difference[n], 200 * 255 * 0.6 / 4095) << device;
            ASSERT_LE(difference[n + 1], 200 * 255 * 0.6 / 470);
            ASSERT_LE(difference[n + 2], 200 * 255 * 0.6 / 470);
        }
    }
}

TEST(SaliencyPrograms, ZeroIsZeroAndBeyondTheRangeIsItsEnd) {
    for (const char* device : {"es3-mid", "es2-small"}) {
        const auto zero = written(device, "void main() { FRAGMENT_COLOR = vec4(triple_of(triple_code(vec3(0.0))), 1.0); }\n");
        EXPECT_EQ(zero[0] + zero[1] + zero[2], 0);
        const auto most = written(device, "void main() { FRAGMENT_COLOR = triple_code(vec3(7.0)); }\n");
        for (int n = 0; n < 4; ++n) EXPECT_EQ(most[n], 255);
        const auto least = written(device, "void main() { FRAGMENT_COLOR = triple_code(vec3(-7.0)); }\n");
        for (int n = 0; n < 4; ++n) EXPECT_EQ(least[n], 0);
    }
}

TEST(SaliencyPrograms, CountsComeBackWithinThreePercent) {
    for (const char* device : {"es3-mid", "es2-small"}) {
        const auto bytes = written(device,
                                   "void main() {\n    float count = floor(exp2(19.0 * uv.x)) - 1.0;\n"
                                   "    float again = counted(count_code(vec4(count))).x;\n"
                                   "    FRAGMENT_COLOR = vec4(10.0 * abs(again - count) / (count + 1.0), count < 1.0 ? 1.0 : 0.0,"
                                   " again, 1.0);\n}\n");
        for (std::size_t n = 0; n < bytes.size(); n += 4) {
            EXPECT_LE(bytes[n], 10 * 255 * 0.03 + 1) << device;
            if (bytes[n + 1] == 255) {
                EXPECT_EQ(bytes[n + 2], 0) << "none is none";
            }
        }
    }
}

TEST(SaliencyPrograms, AreMadeForWhatIsShownAlone) {
    GlSession session("egl", "es2-small", kSide, kSide);
    SaliencyPrograms programs;
    EXPECT_FALSE(programs.has(SaliencyStep::lab));
    ASSERT_EQ(programs.start(session.gl, 2, false, true).message.view(), "");
    for (std::size_t n = 0; n < kSaliencySteps; ++n)
        EXPECT_EQ(programs.has(static_cast<SaliencyStep>(n)), static_cast<SaliencyStep>(n) != SaliencyStep::show_map) << n;
    programs.destroy(session.gl);
    EXPECT_EQ(session.gl.denied().total, 0u);
}

}  // namespace
}  // namespace tedavis::draw::test_saliency_programs
