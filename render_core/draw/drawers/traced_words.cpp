#include "render_core/draw/drawers/traced_words.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "render_core/base/check.hpp"
#include "render_core/draw/drawers/traced_surface.hpp"

namespace tedavis::draw {
namespace {

using raytrace::HitSide;

constexpr std::uint32_t kWordRowsOfTask = 8;
constexpr std::uint64_t kArrays = 3, kAlignment = 64;
constexpr float kPartSteps = 65535.0f, kNormalSteps = 1023.0f;
constexpr std::uint32_t kNormalBits = 10, kSeaBit = 20, kUnknownBit = 21, kNumberBit = 22;

std::uint32_t bits_of(float value) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

/// Without lround(), which would be a call for each pixel.
std::uint32_t rounded(float steps) {
    const float above = steps + 0.5f;
    return static_cast<std::uint32_t>(above);
}

/// Octahedral form (Meyer et al. 2010) of a vector of any length but 0.
std::uint32_t normal_code(float x, float y, float z) {
    const float scale = 1 / std::max(std::fabs(x) + std::fabs(y) + std::fabs(z), 1e-6f);
    float a = x * scale, b = y * scale;
    if (z < 0) {
        const float upper = (1 - std::fabs(b)) * (a < 0 ? -1.0f : 1.0f);
        b = (1 - std::fabs(a)) * (b < 0 ? -1.0f : 1.0f);
        a = upper;
    }
    const auto code = [](float at) { return rounded(std::clamp(at * 0.5f + 0.5f, 0.0f, 1.0f) * kNormalSteps); };
    return code(a) | code(b) << kNormalBits;
}

struct WordsJob {
    const WordsInput& input;
    const TracedSurface surface;
    const std::uint16_t* numbers;
    std::uint32_t across;  ///< numbers in a row
    const TracedWords::Part* parts;
    GeometryWords* words;
};

GeometryWords words_of(const WordsJob& job, std::size_t pixel) {
    const TracedPoint point = job.surface.at(pixel);
    const std::uint32_t number = job.numbers[point.row / terrain::kChunkCells * job.across + point.column / terrain::kChunkCells];
    const TracedWords::Part& part = job.parts[number];
    const float east = (static_cast<float>(point.column - part.i0) + point.u) * part.per_column;
    const float south = (static_cast<float>(point.row - part.j0) + point.v) * part.per_row;
    std::uint32_t look = normal_code(sum_of(point.shares * point.normals_x()), sum_of(point.shares * point.normals_y()),
                                     sum_of(point.shares * point.normals_z()));
    if (point.is_sea) look |= 1u << kSeaBit;
    if (point.is_unknown) look |= 1u << kUnknownBit;
    return {rounded(std::clamp(east, 0.0f, 1.0f) * kPartSteps) | rounded(std::clamp(south, 0.0f, 1.0f) * kPartSteps) << 16u,
            bits_of(point.height_m), look | number << kNumberBit, bits_of(job.input.hits.t[pixel])};
}

void write_rows(const WordsJob& job, std::uint32_t task) {
    const terrain::View& view = job.input.view;
    for (std::uint32_t y = task * kWordRowsOfTask; y < std::min(view.height, (task + 1) * kWordRowsOfTask); ++y) {
        GeometryWords* to = job.words + std::size_t{view.height - 1 - y} * view.width;
        for (std::uint32_t x = 0; x < view.width; ++x, ++to) {
            const std::size_t at = std::size_t{y} * view.width + x;
            *to = job.input.hits.side[at] == HitSide::none ? GeometryWords{} : words_of(job, at);
        }
    }
}

}  // namespace

std::uint64_t TracedWords::bytes_needed(const terrain::Lattice& lattice, std::uint32_t width, std::uint32_t height) {
    const std::uint64_t chunks = std::uint64_t{lattice.grid_columns(0)} * lattice.grid_rows(0);
    return std::uint64_t{width} * height * sizeof(GeometryWords) + chunks * sizeof(std::uint16_t) +
           (kMaxGeometrySlots + 1) * sizeof(Part) + kArrays * kAlignment;
}

bool TracedWords::start(const terrain::Lattice& lattice, std::uint32_t width, std::uint32_t height, base::Arena& arena) {
    lattice_ = lattice;
    across_ = lattice.grid_columns(0);
    down_ = lattice.grid_rows(0);
    numbers_ = arena.allocate_array<std::uint16_t>(std::size_t{across_} * down_);
    parts_ = arena.allocate_array<Part>(kMaxGeometrySlots + 1);
    words_ = arena.allocate_array<GeometryWords>(std::size_t{width} * height);
    if (!parts_.empty()) parts_[0] = {};  // of ground without a chunk
    return !numbers_.empty() && !parts_.empty() && !words_.empty();
}

void TracedWords::assign(base::Span<const terrain::SelectedChunk> chunks) {
    std::fill(numbers_.begin(), numbers_.end(), std::uint16_t{0});
    for (const terrain::SelectedChunk& chunk : chunks) {
        TEDAVIS_CHECK(chunk.slot < kMaxGeometrySlots);
        const terrain::PostRange posts = lattice_.posts_of(chunk.key);
        parts_[geometry_number(chunk)] = {posts.i0, posts.j0, 1 / static_cast<float>(posts.i1 - posts.i0),
                                          1 / static_cast<float>(posts.j1 - posts.j0)};
        const std::uint32_t level = chunk.key.level;
        const std::uint32_t right = std::min((chunk.key.i + 1) << level, across_);
        for (std::uint32_t j = chunk.key.j << level; j < std::min((chunk.key.j + 1) << level, down_); ++j)
            for (std::uint32_t i = chunk.key.i << level; i < right; ++i)
                numbers_[std::size_t{j} * across_ + i] = static_cast<std::uint16_t>(geometry_number(chunk));
    }
}

void TracedWords::write(const WordsInput& input, base::Workers& workers) {
    TEDAVIS_CHECK(std::size_t{input.view.width} * input.view.height == words_.size());
    assign(input.chunks);
    WordsJob job{input, {input.ground, input.hits}, numbers_.data(), across_, parts_.data(), words_.data()};
    const auto task = [](void* context, std::uint32_t n) { write_rows(*static_cast<WordsJob*>(context), n); };
    workers.parallel_for((input.view.height + kWordRowsOfTask - 1) / kWordRowsOfTask, task, &job);
}

}  // namespace tedavis::draw
