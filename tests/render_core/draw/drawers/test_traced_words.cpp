#include "render_core/draw/drawers/traced_words.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <vector>

#include "platform/threads/thread_workers.hpp"
#include "render_core/draw/drawers/traced_codes.hpp"
#include "render_core/draw/traced_view.hpp"
#include "tests/support/raytrace/traced_file.hpp"

namespace tedavis::draw::test_traced_words {
namespace {

using raytrace::HitSide;
using test_support::TracedFile;

const TracedFile& coast() {
    static const TracedFile file(test_support::coast_file());
    return file;
}

/// Chunks of two levels: the two coarse ones of the west, and the fine ones east of them.
std::vector<terrain::SelectedChunk> selection(const terrain::Lattice& lattice) {
    std::vector<terrain::SelectedChunk> chunks;
    const auto add = [&](const terrain::ChunkKey& key) {
        terrain::SelectedChunk chunk;
        chunk.key = key;
        chunk.slot = static_cast<terrain::SlotIndex>(chunks.size() + 3);
        chunks.push_back(chunk);
    };
    for (std::uint32_t j = 0; j < lattice.grid_rows(1); ++j) add({1, 0, j});
    for (std::uint32_t j = 0; j < lattice.grid_rows(0); ++j)
        for (std::uint32_t i = 2; i < lattice.grid_columns(0); ++i) add({0, i, j});
    return chunks;
}

float float_of(std::uint32_t bits) {
    float value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

/// By Meyer et al. 2010, section 3.2, from the code alone.
glm::dvec3 normal_of(std::uint32_t word) {
    const double a = (word & 1023u) * 2 / 1023.0 - 1, b = (word >> 10u & 1023u) * 2 / 1023.0 - 1;
    glm::dvec3 n(a, b, 1 - std::abs(a) - std::abs(b));
    if (n.z < 0) n = {(1 - std::abs(b)) * (a < 0 ? -1 : 1), (1 - std::abs(a)) * (b < 0 ? -1 : 1), n.z};
    return glm::normalize(n);
}

/// A traced picture of the coast and its words.
struct Picture {
    explicit Picture(base::Workers& workers, double heading_deg = 250) {
        view = coast().view(80, 64, 900, heading_deg, -20);
        memory.resize(TracedView::bytes_needed(view.width, view.height) / 8 +
                      TracedWords::bytes_needed(lattice(), view.width, view.height) / 8 + 2);
        base::Arena arena(memory.data(), memory.size() * 8);
        EXPECT_TRUE(traced.start(view.width, view.height, arena));
        EXPECT_TRUE(words.start(lattice(), view.width, view.height, arena));
        traced.trace(coast().ground, coast().space(), view, workers);
        chunks = selection(lattice());
        words.write({coast().ground, traced.hits(), view, {chunks.data(), chunks.size()}}, workers);
    }
    [[nodiscard]] const terrain::Lattice& lattice() const { return coast().of.database.lattice(); }
    [[nodiscard]] const GeometryWords& at(std::uint32_t x, std::uint32_t y) const {
        return words.words()[std::size_t{view.height - 1 - y} * view.width + x];
    }

    terrain::View view;
    std::vector<std::uint64_t> memory;
    TracedView traced;
    TracedWords words;
    std::vector<terrain::SelectedChunk> chunks;
};

TEST(TracedWords, SayWhereTheGroundWasMetInTheChunkThatCoversIt) {
    base::SerialWorkers workers;
    const Picture picture(workers);
    const raytrace::HitPicture& hits = picture.traced.hits();
    const std::uint32_t cells = picture.lattice().columns() - 1;
    std::size_t met = 0, coarse = 0;
    for (std::uint32_t y = 0; y < picture.view.height; ++y)
        for (std::uint32_t x = 0; x < picture.view.width; ++x) {
            const std::size_t at = std::size_t{y} * picture.view.width + x;
            const GeometryWords& words = picture.at(x, y);
            if (hits.side[at] == HitSide::none) {
                ASSERT_EQ(words, GeometryWords{});
                continue;
            }
            ++met;
            const std::uint32_t number = words[2] >> 22u;
            const terrain::SelectedChunk* owner = nullptr;
            for (const terrain::SelectedChunk& chunk : picture.chunks)
                if (geometry_number(chunk) == number) owner = &chunk;
            ASSERT_NE(owner, nullptr) << number;
            const terrain::PostRange posts = picture.lattice().posts_of(owner->key);
            const auto cell = static_cast<std::uint32_t>(hits.cell[at]);
            ASSERT_TRUE(cell % cells >= posts.i0 && cell % cells < posts.i1) << "its cell lies in the chunk";
            ASSERT_TRUE(cell / cells >= posts.j0 && cell / cells < posts.j1);
            coarse += owner->key.level == 1 ? 1 : 0;
            const std::uint32_t whole_row = cell / cells;
            const double column = cell - whole_row * cells, row = whole_row;
            const double across = posts.i1 - posts.i0, down = posts.j1 - posts.j0;
            EXPECT_NEAR(posts.i0 + (words[0] & 65535u) / 65535.0 * across, column + double{hits.u[at]}, across / 65535);
            EXPECT_NEAR(posts.j0 + (words[0] >> 16u) / 65535.0 * down, row + double{hits.v[at]}, down / 65535);
            EXPECT_EQ(float_of(words[3]), hits.t[at]);
        }
    EXPECT_GT(met, 1000u);
    EXPECT_GT(coarse, 100u);
    EXPECT_LT(coarse, met - 100);
}

/// The triangle's own corners are interpolated anew, in double, from the posts.
TEST(TracedWords, HeightAndNormalAreThoseOfTheTriangle) {
    base::SerialWorkers workers;
    const Picture picture(workers);
    const raytrace::HitPicture& hits = picture.traced.hits();
    const raytrace::HeightGrid<float>& grid = coast().ground.heights();
    const auto look = [&](std::uint32_t i, std::uint32_t j) {
        const PostLook& of = coast().ground.looks()[std::size_t{j} * grid.stride + i];
        return glm::dvec3(of.normal[0], of.normal[1], of.normal[2]);
    };
    for (std::size_t at = 0; at < hits.t.size(); at += 7) {
        if (hits.side[at] == HitSide::none) continue;
        const auto cell = static_cast<std::uint32_t>(hits.cell[at]);
        const std::uint32_t i = cell % (grid.columns - 1), j = cell / (grid.columns - 1);
        const double u = double{hits.u[at]}, v = double{hits.v[at]};
        const bool upper = hits.u[at] + hits.v[at] <= 1;
        const double first = upper ? 1 - u - v : u + v - 1, east = upper ? u : 1 - v, south = upper ? v : 1 - u;
        const std::uint32_t fi = upper ? i : i + 1, fj = upper ? j : j + 1;
        const double height_m =
            first * double{grid.at(fi, fj)} + east * double{grid.at(i + 1, j)} + south * double{grid.at(i, j + 1)};
        const glm::dvec3 normal = glm::normalize(first * look(fi, fj) + east * look(i + 1, j) + south * look(i, j + 1));
        const std::uint32_t y = static_cast<std::uint32_t>(at) / picture.view.width,
                            x = static_cast<std::uint32_t>(at) % picture.view.width;
        const GeometryWords& words = picture.at(x, y);
        EXPECT_NEAR(double{float_of(words[1])}, height_m, 1e-3);
        EXPECT_GT(glm::dot(normal_of(words[2]), normal), std::cos(0.004)) << "ten bits each";
    }
}

TEST(TracedWords, TheClassOfTheGroundIsThatOfTheCodes) {
    base::SerialWorkers workers;
    std::size_t sea = 0, unknown = 0;
    for (const double heading_deg : {250.0, 110.0}) {
        const Picture picture(workers, heading_deg);
        const raytrace::HitPicture& hits = picture.traced.hits();
        std::vector<std::uint8_t> codes(4 * hits.t.size());
        write_codes({coast().ground, hits, picture.view, {400, 1200}, {}, nullptr}, workers, codes);
        for (std::size_t n = 0; n < hits.t.size(); ++n) {
            const std::uint32_t look = picture.words.words()[n][2];
            if (look >> 22u == 0) continue;
            EXPECT_EQ((look >> 20u & 1u) != 0, codes[4 * n] == 254 && codes[4 * n + 1] == 0);
            EXPECT_EQ((look >> 21u & 1u) != 0, codes[4 * n + 2] == 0);
            sea += look >> 20u & 1u;
            unknown += look >> 21u & 1u;
        }
    }
    EXPECT_GT(sea, 50u);
    EXPECT_GT(unknown, 10u);
}

TEST(TracedWords, DoNotDependOnTheNumberOfWorkers) {
    base::SerialWorkers one;
    const auto two = platform::make_thread_workers({2, nullptr});
    ASSERT_TRUE(two.ok());
    const Picture alone(one), shared(*two.value());
    EXPECT_TRUE(std::equal(alone.words.words().begin(), alone.words.words().end(), shared.words.words().begin()));
}

}  // namespace
}  // namespace tedavis::draw::test_traced_words
