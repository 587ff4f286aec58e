// What -ffp-contract=off is for (NUMERICS A43): with leave to fuse, edges have gaps and kernels other bits; the project has
// neither, and its objects have no fused instruction.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <random>
#include <regex>
#include <string>

#include "tests/support/contraction/seams.hpp"
#include "tests/support/files/hard_case.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/raytrace/traced_ground.hpp"

namespace tedavis::raytrace::test_ray_contraction {
namespace {

using test_support::EdgeSeams;
using test_support::SeamsAsCompiled;
using test_support::TracedGround;

TEST(RayContraction, EdgesAreEvenAndWithoutGaps) {
    const EdgeSeams found = test_support::seams_as_the_project().edges(3'000'000);
    EXPECT_EQ(found.uneven, 0U);
    EXPECT_EQ(found.gaps, 0U);
    test_support::record_worst("A26", static_cast<double>(found.gaps));
    test_support::record_worst("A43", static_cast<double>(found.uneven));
}

TEST(RayContraction, LeaveToFuseOpensGaps) {
    if (!test_support::has_fused_instructions()) return;  // nothing can go wrong there either
    const EdgeSeams found = test_support::seams_fused().edges(3'000'000);
    EXPECT_GT(found.uneven, found.points * 9 / 10);
    EXPECT_GT(found.gaps, found.points / 1000);
    test_support::record_control("A26", static_cast<double>(found.gaps));
    test_support::record_control("A43", static_cast<double>(found.uneven));
}

struct Bits {
    int other_t = 0, other_side = 0, hits = 0;
};

/// Against trace_ray().
Bits compared(const SeamsAsCompiled& seams) {
    const TracedGround<std::int16_t> ground(test_support::rough_heights(77, 70, 50, 8));
    std::mt19937 dice(5);
    const auto in = [&](double low, double high) { return low + (high - low) * (dice() * 0x1p-32); };
    Bits found;
    for (int n = 0; n < 200'000; ++n) {
        const Ray ray{{in(0, 76), in(0, 69), in(51, 90)},
                      {static_cast<float>(in(-1, 1)), static_cast<float>(in(-1, 1)), static_cast<float>(in(-3, -0.2))}};
        const Hit expected = ground.trace(ray), hit = seams.trace(*ground.traced(CellSurface::two_triangles).maxima, ray);
        found.hits += hit.side == HitSide::above;
        found.other_side += hit.side != expected.side;
        found.other_t += std::memcmp(&hit.t, &expected.t, sizeof(float)) != 0;
    }
    return found;
}

TEST(RayContraction, KernelsHaveTheSameBitsOnlyWithoutIt) {
    const Bits project = compared(test_support::seams_as_the_project());
    EXPECT_GT(project.hits, 100'000);
    EXPECT_EQ(project.other_t, 0);
    EXPECT_EQ(project.other_side, 0);
    if (!test_support::has_fused_instructions()) return;
    EXPECT_GT(compared(test_support::seams_fused()).other_t, 1000);
}

/// How many fused instructions an archive's code has.
int fused_instructions(const std::string& archive_name) {
    static const std::regex fused("\\s(vfn?m(add|sub)\\w+|fn?m(add|sub)|fml[as]|vfn?m[as]\\.f\\d+)\\s");
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test_support::binary_dir())) {
        if (entry.path().filename() != archive_name) continue;
        const std::string command = "objdump -d --no-show-raw-insn '" + entry.path().string() + "'";
        const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
        EXPECT_TRUE(pipe);
        std::array<char, 4096> line;
        int lines = 0;
        for (; pipe && std::fgets(line.data(), static_cast<int>(line.size()), pipe.get()) != nullptr; ++lines)
            if (std::strstr(line.data(), "fm") != nullptr || std::strstr(line.data(), "fnm") != nullptr)
                count += std::regex_search(line.data(), fused);
        EXPECT_GT(lines, 100) << archive_name << ": objdump wrote nothing";
        return count;
    }
    ADD_FAILURE() << archive_name << " is not there";
    return count;
}

/// Those that this program links, and so are there.
TEST(RayContraction, NoKernelHasFusedInstructions) {
    for (const char* const module : {"earth", "scene", "terrain", "draw", "raytrace"})
        EXPECT_EQ(fused_instructions("libtedavis_render_core_" + std::string(module) + ".a"), 0) << module;
    EXPECT_GT(fused_instructions("libtedavis_test_seams.a"), 20);
}

}  // namespace
}  // namespace tedavis::raytrace::test_ray_contraction
