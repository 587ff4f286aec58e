#include "render_core/draw/drawers/edge_programs.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "render_core/draw/shader_texts.hpp"
#include "tests/support/draw/screen_triangle.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_edge_programs {
namespace {

using test_support::GlSession;

constexpr std::uint32_t kSide = 256;

/// What a fragment writes; it sees the codes of edges, and `n` of its column and `m` of its row, each 0 to 255.
std::vector<std::uint8_t> written_with_codes(const std::string& device, const std::string& value) {
    GlSession session("egl", device, kSide, kSide);
    const std::string main =
        "void main() {\n    float n = floor(gl_FragCoord.x), m = floor(gl_FragCoord.y);\n    FRAGMENT_COLOR = " + value +
        " / 255.0;\n}\n";
    test_support::ScreenTriangle triangle(session.gl, std::string(shader_text(k_edge_codes_frag)) + main, {});
    triangle.program().use(session.gl);
    triangle.draw(session.gl);
    std::vector<std::uint8_t> bytes = session.pixels();
    triangle.destroy(session.gl);
    return bytes;
}

TEST(EdgePrograms, TwoBytesAreFourRowsOfFourPixels) {
    for (const char* device : {"es3-mid", "es2-small"}) {
        const auto rows = written_with_codes(device, "rows_of(vec2(n, m))");
        const auto bits = written_with_codes(device, "bits_of(floor(n / 16.0))");
        const auto again = written_with_codes(device, "vec4(row_of(bits_of(floor(n / 16.0))))");
        for (std::uint32_t y = 0; y < kSide; ++y)
            for (std::uint32_t x = 0; x < kSide; ++x) {
                const std::size_t at = 4 * (std::size_t{y} * kSide + x);
                const std::uint32_t expected[4] = {x % 16, x / 16, y % 16, y / 16};
                for (std::size_t k = 0; k < 4; ++k) {
                    ASSERT_EQ(rows[at + k], expected[k]) << device << " " << x << " " << y;
                    ASSERT_EQ(bits[at + k], x / 16 >> k & 1u) << device << " " << x;
                }
                ASSERT_EQ(again[at], x / 16) << device;
            }
    }
}

TEST(EdgePrograms, ABandsColumnsAreFoundToTheLast) {
    for (const char* device : {"es3-mid", "es2-small"})
        for (const std::uint32_t columns : {1u, 3u, 66u}) {
            const auto places = written_with_codes(device, "vec4(in_band(n, " + std::to_string(columns) + ".0), 0.0, 255.0)");
            for (std::uint32_t x = 0; x < kSide; ++x) {
                EXPECT_EQ(places[4 * x], x / columns) << device << " " << columns;
                EXPECT_EQ(places[4 * x + 1], x % columns) << device << " " << columns;
            }
        }
}

TEST(EdgePrograms, AreMadeForWhatIsShownAlone) {
    GlSession session("egl", "es2-small");
    for (const bool shows : {false, true}) {
        EdgePrograms programs;
        EXPECT_FALSE(programs.has(EdgeStep::planes));
        ASSERT_EQ(programs.start(session.gl, {20, 30}, shows).message.view(), "");
        for (std::size_t n = 0; n < kEdgeSteps; ++n) {
            const auto step = static_cast<EdgeStep>(n);
            EXPECT_EQ(programs.has(step), shows || (step != EdgeStep::show_edges && step != EdgeStep::show_regions)) << n;
        }
        programs.destroy(session.gl);
    }
    EXPECT_EQ(session.gl.denied().total, 0u);
}

}  // namespace
}  // namespace tedavis::draw::test_edge_programs
