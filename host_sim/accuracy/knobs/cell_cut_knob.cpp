#include "host_sim/accuracy/knobs/cell_cut_knob.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "host_sim/scenario/seeded_random.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"
#include "render_core/scene/isosurface.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::uint32_t kSidePosts = 25, kSideCells = kSidePosts - 1;
constexpr std::size_t kCutFields = 32, kQuickCutFields = 8, kWavesOfField = 24;
constexpr std::size_t kCutRoom = 1 << 17;
constexpr double kMillion = 1e6;
constexpr unsigned kAxisBits[3] = {1, 2, 4};

constexpr std::size_t kKuhnLevel = 0, kMirroredLevel = 1;
constexpr const char* kCutLevelNames[] = {"six tetrahedra", "five tetrahedra, mirrored in every second cell",
                                          "five tetrahedra, all cells alike"};

KnobFacts cell_cut_facts() {
    std::vector<KnobLevel> levels;
    for (const char* const name : kCutLevelNames) levels.push_back({name, 0});
    return {
        "cell_cut",
        "Tetrahedra that a cell of a field is cut into",
        "scene::IsosurfaceBuilder; of the alternatives triangles are timed without the places and normals of their corners",
        "open edges inside a rough field, and faces of cells that join what the trilinear surface parts or part what it joins",
        "per million cells",
        {"the bilinear surface on each face of a cell, by the asymptotic decider", 0,
         "it is decided by the sign of a difference of two products of floats in double"},
        "parts of each face that hang together, found by filling (tests/host_sim/accuracy)",
        "Terrain alerts and warned-of areas are not drawn from isosurfaces.",
        "no scale: three ways to cut a cell",
        std::nullopt,
        std::move(levels),
        "its surface has no open edge, all cells are alike, and a field's values between posts are not known well enough to "
        "say which corners of a face hang together"};
}

/// A sum of waves, so short that many faces are ambiguous.
std::vector<float> rough_field(SeededRandom& numbers) {
    struct Wave {
        double x, y, z, phase;
    };
    std::vector<Wave> waves;
    for (std::size_t n = 0; n < kWavesOfField; ++n)
        waves.push_back({numbers.within(0, 1.6), numbers.within(0, 1.6), numbers.within(0, 1.6), numbers.within(0, base::kPi)});
    std::vector<float> values;
    for (std::uint32_t z = 0; z < kSidePosts; ++z)
        for (std::uint32_t y = 0; y < kSidePosts; ++y)
            for (std::uint32_t x = 0; x < kSidePosts; ++x) {
                double sum = 0;
                for (const Wave& wave : waves) sum += std::sin(wave.x * x + wave.y * y + wave.z * z + wave.phase);
                values.push_back(static_cast<float>(sum));
            }
    return values;
}

struct FieldPost {
    std::uint32_t x, y, z;

    [[nodiscard]] std::uint32_t number() const { return (z * kSidePosts + y) * kSidePosts + x; }
    [[nodiscard]] FieldPost corner(unsigned bits) const { return {x + (bits & 1), y + (bits >> 1 & 1), z + (bits >> 2)}; }
    static FieldPost of(std::uint32_t number) {
        return {number % kSidePosts, number / kSidePosts % kSidePosts, number / (kSidePosts * kSidePosts)};
    }
};

/// The sides of the field that a place lies on, a bit each.
template <class Number>
unsigned borders_of(Number x, Number y, Number z) {
    const auto end = static_cast<Number>(kSideCells), begin = static_cast<Number>(0);
    return (x == begin ? 1u : 0u) | (x == end ? 2u : 0u) | (y == begin ? 4u : 0u) | (y == end ? 8u : 0u) |
           (z == begin ? 16u : 0u) | (z == end ? 32u : 0u);
}

/// A triangle's side from one corner to another, the lower number first.
using TriangleSide = std::pair<std::uint64_t, std::uint64_t>;

/// Sides inside the field that do not belong to two triangles. `borders` tells the borders that a corner lies on.
template <class Borders>
std::size_t open_sides(std::vector<TriangleSide>& sides, const Borders& borders) {
    std::sort(sides.begin(), sides.end());
    std::size_t open = 0;
    for (auto first = sides.begin(); first != sides.end();) {
        const auto last = std::find_if(first, sides.end(), [&](const TriangleSide& side) { return side != *first; });
        open += last - first != 2 && (borders(first->first) & borders(first->second)) == 0 ? 1 : 0;
        first = last;
    }
    return open;
}

void add_sides(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::vector<TriangleSide>& sides) {
    for (const TriangleSide& side : {TriangleSide{a, b}, TriangleSide{b, c}, TriangleSide{c, a}})
        sides.push_back(std::minmax(side.first, side.second));
}

/// Five tetrahedra of a cell: one in the middle, of the corners with an even number of steps from the first, and four round it;
/// mirrored along x.
constexpr unsigned kFive[5][4] = {{0, 3, 5, 6}, {1, 0, 3, 5}, {2, 0, 3, 6}, {4, 0, 5, 6}, {7, 3, 5, 6}};
unsigned mirrored(unsigned corner, bool is_mirrored) { return is_mirrored ? corner ^ 1u : corner; }

/// A corner of a triangle: the edge between two posts that it lies on.
std::uint64_t edge_number(std::uint32_t a, std::uint32_t b) { return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b); }

class CutField {
public:
    explicit CutField(SeededRandom& numbers) : values_(rough_field(numbers)) {}

    [[nodiscard]] scene::VolumeView view() const {
        return {{values_.data(), values_.size()}, kSidePosts, kSidePosts, kSidePosts};
    }
    /// The triangles by five tetrahedra a cell.
    void cut_by_five(bool has_mirrors, std::vector<std::array<std::uint64_t, 3>>& triangles) const {
        triangles.clear();
        for_each_cell([&](const FieldPost& cell) {
            const bool is_mirrored = has_mirrors && (cell.x + cell.y + cell.z) % 2 == 1;
            for (const auto& tetrahedron : kFive) {
                std::uint32_t posts[4];
                for (int n = 0; n < 4; ++n) posts[n] = cell.corner(mirrored(tetrahedron[n], is_mirrored)).number();
                cut_tetrahedron(posts, triangles);
            }
        });
    }
    /// Ambiguous faces between cells that a level decides otherwise than the surface on the face.
    [[nodiscard]] std::size_t wrong_faces(std::size_t level) const {
        std::size_t wrong = 0;
        for_each_cell([&](const FieldPost& cell) {
            for (int axis = 0; axis < 3; ++axis) {
                const unsigned far = kAxisBits[axis], u = kAxisBits[(axis + 1) % 3], v = kAxisBits[(axis + 2) % 3];
                const unsigned corners[4] = {far, far | u, far | v, far | u | v};
                FaceValues face{};
                for (unsigned n = 0; n < 4; ++n) face.corner[n & 1][n >> 1] = value(cell.corner(corners[n]));
                if (!face.is_ambiguous()) continue;
                const bool is_diagonal_inside = face.corner[0][0] >= 0;
                const bool joins = level == kKuhnLevel ? kuhn_joins(cell, corners, is_diagonal_inside)
                                                       : five_join(level, cell, corners[0]) == is_diagonal_inside;
                wrong += joins != face.joins_inside() ? 1 : 0;
            }
        });
        return wrong;
    }

private:
    template <class Visit>
    static void for_each_cell(const Visit& visit) {
        for (std::uint32_t z = 0; z < kSideCells; ++z)
            for (std::uint32_t y = 0; y < kSideCells; ++y)
                for (std::uint32_t x = 0; x < kSideCells; ++x) visit(FieldPost{x, y, z});
    }
    [[nodiscard]] double value(const FieldPost& post) const { return static_cast<double>(values_[post.number()]); }
    [[nodiscard]] bool is_inside(std::uint32_t post) const { return values_[post] >= 0; }

    void cut_tetrahedron(const std::uint32_t (&posts)[4], std::vector<std::array<std::uint64_t, 3>>& triangles) const {
        std::uint32_t in[4], out[4];
        int ins = 0, outs = 0;
        for (const std::uint32_t post : posts) (is_inside(post) ? in[ins++] : out[outs++]) = post;
        if (ins == 0 || outs == 0) return;
        if (ins == 2) {
            const std::uint64_t a = edge_number(in[0], out[0]), b = edge_number(in[0], out[1]), c = edge_number(in[1], out[1]);
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, edge_number(in[1], out[0])});
            return;
        }
        const std::uint32_t tip = ins == 1 ? in[0] : out[0], *const others = ins == 1 ? out : in;
        triangles.push_back({edge_number(tip, others[0]), edge_number(tip, others[1]), edge_number(tip, others[2])});
    }
    /// By the product's table: its triangles join the inside corners where none of their sides cuts one of them off.
    [[nodiscard]] bool kuhn_joins(const FieldPost& cell, const unsigned (&corners)[4], bool is_diagonal_inside) const {
        unsigned inside_bits = 0;
        for (unsigned n = 0; n < 8; ++n) inside_bits |= is_inside(cell.corner(n).number()) ? 1u << n : 0u;
        const unsigned cut = is_diagonal_inside ? corners[0] : corners[1];
        const unsigned beside[2] = {is_diagonal_inside ? corners[1] : corners[0], is_diagonal_inside ? corners[2] : corners[3]};
        const scene::KuhnCase& made = scene::kKuhnCases[inside_bits];
        for (int n = 0; n < made.triangles; ++n) {
            int ends = 0;
            for (const scene::KuhnEdge& edge : made.edge[n])
                for (const unsigned other : beside)
                    ends += edge.corner == std::min(cut, other) && edge.direction == (cut ^ other);
            if (ends == 2) return false;
        }
        return true;
    }
    /// Whether the diagonal from the face's first corner is an edge of the tetrahedra.
    [[nodiscard]] static bool five_join(std::size_t level, const FieldPost& cell, unsigned first_corner) {
        const bool is_mirrored = level == kMirroredLevel && (cell.x + cell.y + cell.z) % 2 == 1;
        const unsigned steps = (first_corner & 1) + (first_corner >> 1 & 1) + (first_corner >> 2);
        return (steps % 2 == 0) != is_mirrored;
    }

    std::vector<float> values_;
};

class CellCutKnob final : public Knob {
public:
    explicit CellCutKnob(const KnobGround& ground)
        : Knob(cell_cut_facts()),
          memory_(scene::IsosurfaceBuilder::bytes_needed(kSidePosts, kSidePosts)),
          vertices_(kCutRoom),
          indices_(3 * kCutRoom) {
        base::Arena arena(memory_.data(), memory_.size());
        if (!builder_.start(arena, kSidePosts, kSidePosts)) throw UserError("no memory for an isosurface");
        SeededRandom numbers(16);
        for (std::size_t n = 0; n < (ground.is_quick ? kQuickCutFields : kCutFields); ++n) fields_.emplace_back(numbers);
    }

    [[nodiscard]] std::size_t samples() const override { return fields_.size(); }
    void run(std::size_t level, std::size_t sample) override {
        if (level != kKuhnLevel) return fields_[sample].cut_by_five(level == kMirroredLevel, triangles_);
        const scene::IsosurfaceOutput output = {{vertices_.data(), vertices_.size()}, {indices_.data(), indices_.size()}};
        const bool is_begun = builder_.begin(fields_[sample].view(), 0, output) == scene::IsosurfaceError::none;
        if (!is_begun || builder_.step(std::numeric_limits<std::uint64_t>::max()) != scene::IsosurfaceProgress::done)
            throw UserError("the measured isosurface finds no room");
    }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        run(level, sample);
        const std::size_t open = level == kKuhnLevel ? open_sides_of_builder() : open_sides_of_five();
        constexpr double kCells = double{kSideCells} * kSideCells * kSideCells;
        errors.push_back(static_cast<double>(open + fields_[sample].wrong_faces(level)) / kCells * kMillion);
    }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t /*error*/) const override {
        return "field " + std::to_string(sample);
    }

private:
    [[nodiscard]] std::size_t open_sides_of_builder() const {
        std::vector<TriangleSide> sides;
        for (std::uint32_t n = 0; n + 2 < builder_.counts().indices; n += 3)
            add_sides(indices_[n], indices_[n + 1], indices_[n + 2], sides);
        return open_sides(sides, [this](std::uint64_t vertex) {
            const glm::vec3 place = vertices_[vertex].position;
            return borders_of(place.x, place.y, place.z);
        });
    }
    [[nodiscard]] std::size_t open_sides_of_five() const {
        std::vector<TriangleSide> sides;
        for (const auto& triangle : triangles_) add_sides(triangle[0], triangle[1], triangle[2], sides);
        return open_sides(sides, [](std::uint64_t edge) {
            const FieldPost a = FieldPost::of(static_cast<std::uint32_t>(edge >> 32)),
                            b = FieldPost::of(static_cast<std::uint32_t>(edge));
            return borders_of(a.x, a.y, a.z) & borders_of(b.x, b.y, b.z);
        });
    }

    std::vector<unsigned char> memory_;
    scene::IsosurfaceBuilder builder_;
    std::vector<scene::IsosurfaceVertex> vertices_;
    std::vector<std::uint32_t> indices_;
    std::vector<std::array<std::uint64_t, 3>> triangles_;
    std::vector<CutField> fields_;
};

}  // namespace

bool FaceValues::is_ambiguous() const {
    const auto is_in = [this](int a, int b) { return corner[a][b] >= 0; };
    return is_in(0, 0) == is_in(1, 1) && is_in(1, 0) == is_in(0, 1) && is_in(0, 0) != is_in(1, 0);
}

bool FaceValues::joins_inside() const {
    const double straight = corner[0][0] * corner[1][1], across = corner[1][0] * corner[0][1];
    return corner[0][0] >= 0 ? straight >= across : across >= straight;
}

std::unique_ptr<Knob> make_cell_cut_knob(const KnobGround& ground) { return std::make_unique<CellCutKnob>(ground); }

}  // namespace tedavis::host_sim
