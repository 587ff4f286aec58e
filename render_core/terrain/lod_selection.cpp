#include "render_core/terrain/lod_selection.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace tedavis::terrain {
namespace {

enum ChunkState : std::uint8_t { kUnseen = 0, kSplit = 1, kChosen = 2 };

constexpr int kTauSteps = 60;  // 2^15 times the tau asked for: beyond that every chunk is a root

struct Box {
    glm::dvec3 centre;   ///< relative to the eye
    glm::dvec3 axis[3];  ///< north, east, down
    double half[3];
};

Box box_of(const ChunkEntry& entry, const View& view) {
    Box box;
    box.centre = glm::dvec3(entry.centre_m[0], entry.centre_m[1], entry.centre_m[2]) - view.eye;
    for (int a = 0; a < 3; ++a) {
        box.axis[a] = glm::dvec3(entry.axes[3 * a], entry.axes[3 * a + 1], entry.axes[3 * a + 2]);
        box.half[a] = entry.half_extent_m[a];
    }
    return box;
}

double reach_along(const Box& box, const glm::dvec3& direction) {
    double reach = 0;
    for (int a = 0; a < 3; ++a) reach += box.half[a] * std::abs(glm::dot(box.axis[a], direction));
    return reach;
}

float distance_m(const ChunkEntry& entry, const View& view) {
    return static_cast<float>(glm::length(glm::dvec3(entry.centre_m[0], entry.centre_m[1], entry.centre_m[2]) - view.eye));
}

double distance_to_grown_box(const Box& box, double grow_factor) {
    double squared = 0;
    for (int a = 0; a < 3; ++a) {
        const double half = box.half[a] * (a < 2 ? grow_factor : 1.0);
        const double outside = std::abs(glm::dot(box.centre, box.axis[a])) - half;
        if (outside > 0) squared += outside * outside;
    }
    return std::sqrt(squared);
}

/// Selection of one tau over the whole tree.
class Selector {
public:
    Selector(const TerrainDatabase& database, const View& view, base::Span<std::uint8_t> states, base::Span<ChunkIndex> work)
        : db_(database), view_(view), states_(states), work_(work) {}

    /// False when the work list overflows; then a larger tau must be tried.
    [[nodiscard]] bool refine(double tau_px) {
        for (std::uint8_t& state : states_) state = kUnseen;
        count_ = 0;
        const std::uint32_t top = db_.levels() - 1;
        for (std::uint32_t j = 0; j < db_.grid_rows(top); ++j)
            for (std::uint32_t i = 0; i < db_.grid_columns(top); ++i)
                if (!choose(db_.at(top, i, j))) return false;
        // `count_` grows while we walk: children are appended. Refused comparisons (NaN) refine.
        for (std::size_t n = 0; n < count_; ++n) {
            const ChunkIndex chunk = work_[n];
            const ChunkEntry& entry = db_.entry(chunk);
            if (entry.level > 0 && !is_outside_view(entry, view_) && !(projected_error_px(entry, view_) <= tau_px))
                if (!split(chunk)) return false;
        }
        return balance();
    }
    [[nodiscard]] base::Span<ChunkIndex> candidates() const { return work_.subspan(0, count_); }
    [[nodiscard]] bool is_chosen(ChunkIndex chunk) const { return states_[chunk] == kChosen; }

    [[nodiscard]] std::uint8_t coarser_edges(ChunkIndex chunk) const {
        const ChunkEntry& e = db_.entry(chunk);
        const std::int64_t i = e.i, j = e.j;
        return static_cast<std::uint8_t>((coarser_at(e.level, i, j - 1) ? 1 : 0) | (coarser_at(e.level, i + 1, j) ? 2 : 0) |
                                         (coarser_at(e.level, i, j + 1) ? 4 : 0) | (coarser_at(e.level, i - 1, j) ? 8 : 0));
    }

private:
    [[nodiscard]] bool choose(ChunkIndex chunk) {
        if (count_ == work_.size()) return false;
        states_[chunk] = kChosen;
        work_[count_++] = chunk;
        return true;
    }
    [[nodiscard]] bool split(ChunkIndex chunk) {
        states_[chunk] = kSplit;
        for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant) {
            const ChunkIndex child = db_.child(chunk, quadrant);
            if (child != kNoChunk && !choose(child)) return false;
        }
        return true;
    }
    /// The chosen chunk that covers the place of (level, i, j), at that level or above; kNoChunk when it is finer or outside.
    [[nodiscard]] ChunkIndex covering(std::uint32_t level, std::int64_t i, std::int64_t j) const {
        for (std::uint32_t up = level; up < db_.levels(); ++up) {
            const ChunkIndex chunk = db_.at(up, i >> (up - level), j >> (up - level));
            if (chunk == kNoChunk || states_[chunk] == kSplit) return kNoChunk;
            if (states_[chunk] == kChosen) return chunk;
        }
        return kNoChunk;
    }
    [[nodiscard]] bool coarser_at(std::uint32_t level, std::int64_t i, std::int64_t j) const {
        const ChunkIndex chunk = covering(level, i, j);
        return chunk != kNoChunk && db_.entry(chunk).level > level;
    }
    /// Splits neighbours that are more than one level coarser; each split can only make work for finer-to-coarser
    /// pairs further on in the list, so one growing walk reaches all, repeated until nothing changes.
    [[nodiscard]] bool balance() {
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t n = 0; n < count_; ++n) {
                if (!is_chosen(work_[n])) continue;
                const ChunkEntry& e = db_.entry(work_[n]);
                const std::int64_t beside[4][2] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
                for (const auto& step : beside) {
                    const ChunkIndex other = covering(e.level, std::int64_t{e.i} + step[0], std::int64_t{e.j} + step[1]);
                    if (other == kNoChunk || db_.entry(other).level <= e.level + 1u) continue;
                    if (!split(other)) return false;
                    changed = true;
                }
            }
        }
        return true;
    }

    const TerrainDatabase& db_;
    const View& view_;
    base::Span<std::uint8_t> states_;
    base::Span<ChunkIndex> work_;
    std::size_t count_ = 0;
};

LodResult collect(const TerrainDatabase& database, const View& view, const Selector& selector, const LodSettings& settings,
                  double tau_px, base::Span<SelectedChunk> selected) {
    LodResult result;
    result.tau_reached_px = tau_px;
    result.within_budget = true;
    const std::size_t capacity = settings.max_chunks < selected.size() ? settings.max_chunks : selected.size();
    for (const ChunkIndex chunk : selector.candidates()) {
        const ChunkEntry& entry = database.entry(chunk);
        if (!selector.is_chosen(chunk) || is_outside_view(entry, view)) continue;
        if (result.chunks == capacity || result.triangles + entry.triangle_count > settings.max_triangles) {
            result.within_budget = false;
            return result;
        }
        const double error = projected_error_px(entry, view);
        if (!(error <= result.worst_error_px)) {
            result.worst_error_px = error;
            result.worst_chunk = chunk;
        }
        selected[result.chunks++] = {chunk, selector.coarser_edges(chunk), static_cast<float>(error), distance_m(entry, view)};
        result.triangles += entry.triangle_count;
    }
    return result;
}

/// Nearest first, so that a depth test spares the shading of what is hidden. A heap sort neither allocates nor recurses.
void order_by_distance(base::Span<SelectedChunk> chunks) {
    const auto nearer = [](const SelectedChunk& a, const SelectedChunk& b) {
        return a.distance_m != b.distance_m ? a.distance_m < b.distance_m : a.chunk < b.chunk;
    };
    std::make_heap(chunks.begin(), chunks.end(), nearer);
    std::sort_heap(chunks.begin(), chunks.end(), nearer);
}

/// Raising tau never adds a chunk, so the least step that fits is found by bisection.
template <typename Attempt>
int least_step_that_fits(const Attempt& attempt) {
    int too_small = 0, step = kTauSteps;
    while (step - too_small > 1) {
        const int middle = (too_small + step) / 2;
        (attempt(middle).within_budget ? step : too_small) = middle;
    }
    return step;
}

}  // namespace

bool is_outside_view(const ChunkEntry& entry, const View& view) {
    const Box box = box_of(entry, view);
    const double depth = glm::dot(box.centre, view.forward);
    if (depth + reach_along(box, view.forward) < view.near_m) return true;
    const double tangents[2] = {view.half_width_tangent(), view.half_height_tangent()};
    const glm::dvec3 sides[2] = {view.right, view.down};
    for (int a = 0; a < 2; ++a) {
        for (const double sign : {-1.0, 1.0}) {
            const glm::dvec3 inward = view.forward * tangents[a] + sides[a] * sign;
            if (glm::dot(box.centre, inward) + reach_along(box, inward) < 0) return true;
        }
    }
    return false;
}

double projected_error_px(const ChunkEntry& entry, const View& view) {
    if (entry.bound_m == 0) return 0;
    const Box box = box_of(entry, view);
    const double tx = view.half_width_tangent(), ty = view.half_height_tangent();
    const double corner = 1.0 + tx * tx + ty * ty;
    const double distance = distance_to_grown_box(box, 2.0);
    const double by_distance = entry.bound_m * view.focal_px * corner / std::fmax(distance, view.near_m);
    // A tighter bound where the whole grown box lies well ahead: its least depth.
    Box grown = box;
    grown.half[0] *= 2.0;
    grown.half[1] *= 2.0;
    const double depth = glm::dot(box.centre, view.forward) - reach_along(grown, view.forward);
    const double by_depth = depth > view.near_m ? entry.bound_m * view.focal_px * std::sqrt(corner) / depth : by_distance;
    return std::fmin(by_distance, by_depth);
}

LodResult select_chunks(const TerrainDatabase& database, const View& view, const LodSettings& settings,
                        base::Span<std::uint8_t> states, base::Span<ChunkIndex> work, base::Span<SelectedChunk> selected) {
    TEDAVIS_CHECK(states.size() >= database.chunk_count());
    Selector selector(database, view, states.subspan(0, database.chunk_count()), work);
    const auto attempt = [&](int step) {
        const double tau = settings.tau_px * std::exp2(0.25 * step);
        return selector.refine(tau) ? collect(database, view, selector, settings, tau, selected) : LodResult{};
    };
    LodResult result = attempt(0);
    if (!result.within_budget) result = attempt(least_step_that_fits(attempt));
    order_by_distance(selected.subspan(0, result.chunks));
    return result;
}

}  // namespace tedavis::terrain
