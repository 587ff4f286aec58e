#include "host_sim/terrain_builder/nested_polyline.hpp"

#include <algorithm>
#include <limits>
#include <queue>

namespace tedavis::host_sim {
namespace {

using terrain::PostClass;

/// A side of the polyline and the post that it misses most.
struct Side {
    std::uint32_t from, to, worst;
    double error_m;

    bool operator<(const Side& o) const { return error_m != o.error_m ? error_m < o.error_m : from > o.from; }
};

class Simplifier {
public:
    explicit Simplifier(const LinePiece& line) : line_(line), level_(line.kept.begin(), line.kept.end()) {
        level_.resize(line.surface_m.size(), 0);
    }

    std::vector<std::uint8_t> run() {
        const auto last = static_cast<std::uint32_t>(level_.size() - 1);
        for (std::uint32_t level = line_.top_level; level >= 1; --level) {
            const std::uint32_t segment = terrain::kChunkCells << (level - 1);
            for (std::uint32_t from = 0; from < last; from += segment) refine(level, from, std::min(from + segment, last));
        }
        return std::move(level_);
    }

private:
    /// From one corner to the next.
    void refine(std::uint32_t level, std::uint32_t from, std::uint32_t to) {
        const double tolerance_m = border_tolerance(level) * line_.tolerance_m(level, line_.first + from);
        std::priority_queue<Side> sides;
        std::uint32_t inserted = 0, begin = from;
        keep(from, level);
        keep(to, level);
        for (std::uint32_t n = from + 1; n <= to; ++n) {
            if (level_[n] < level) continue;
            sides.push(measured(level, begin, n));
            begin = n;
            ++inserted;
        }
        while (!sides.empty() && sides.top().error_m > tolerance_m && inserted <= kMaxBorderInsertions) {
            const Side side = sides.top();
            sides.pop();
            keep(side.worst, level);
            ++inserted;
            sides.push(measured(level, side.from, side.worst));
            sides.push(measured(level, side.worst, side.to));
        }
    }

    void keep(std::uint32_t n, std::uint32_t level) { level_[n] = std::max(level_[n], static_cast<std::uint8_t>(level)); }
    [[nodiscard]] bool may_stay(std::uint32_t n, std::uint32_t level) const {
        return line_.most.empty() || line_.most[n] >= level;
    }
    [[nodiscard]] bool is_void(std::uint32_t n) const { return line_.post_class[n] == PostClass::void_; }

    [[nodiscard]] Side measured(std::uint32_t level, std::uint32_t from, std::uint32_t to) const {
        const double span = to - from, first = line_.surface_m[from], rise = line_.surface_m[to] - first;
        const double sagitta_m = line_.sagitta_m * span * span;
        const bool void_end = is_void(from) || is_void(to);
        Side side{from, to, from + (to - from) / 2, sagitta_m};
        if (to - from < 2 || !may_stay(side.worst, level)) side.error_m = 0;
        for (std::uint32_t n = from + 1; n < to; ++n) {
            if (!may_stay(n, level)) continue;
            if (is_void(n)) {
                if (!void_end) return {from, to, n, std::numeric_limits<double>::infinity()};
                continue;
            }
            const double above_m = first + rise * ((n - from) / span) - line_.surface_m[n];
            const double error_m = std::max(above_m, sagitta_m - above_m);
            if (error_m > side.error_m) {
                side.error_m = error_m;
                side.worst = n;
            }
        }
        return side;
    }

    const LinePiece& line_;
    std::vector<std::uint8_t> level_;
};

}  // namespace

std::vector<std::uint8_t> keep_levels(const LinePiece& line) { return Simplifier(line).run(); }

}  // namespace tedavis::host_sim
