/// How answers of a tracer stand beside those of the reference.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/support/raytrace/reference_trace.hpp"

namespace tedavis::test_support {

/// A tracer in 32-bit floats makes a height over the surface by at most eight roundings of the numbers that make up a margin.
inline constexpr long double kFloatMargin = 8 * 0x1p-24L;

struct TraceAgreement {
    std::uint64_t rays = 0, hits = 0;
    std::uint64_t different = 0;    ///< one meets the surface, the other does not
    std::uint64_t unexplained = 0;  ///< of those: the ray is further from another answer than floats err
    std::uint64_t close = 0;        ///< rays that are not
    std::uint64_t misplaced = 0;    ///< both meet it, far from another answer, and t differs by more than twice what floats err
    std::vector<float> relative_t;  ///< differences of t over t, where both meet it

    void add(const ReferenceHit& expected, bool is_hit, float t) {
        const bool is_close = expected.margin <= kFloatMargin, should_hit = expected.side != raytrace::HitSide::none;
        ++rays;
        close += is_close;
        hits += should_hit;
        different += should_hit != is_hit;
        unexplained += should_hit != is_hit && !is_close;
        if (!should_hit || !is_hit) return;
        const long double apart = std::abs(t - expected.t), relative = expected.t > 0 ? apart / expected.t : apart;
        misplaced += !is_close && apart > 2 * kFloatMargin * (expected.t_scale + expected.t);
        relative_t.push_back(static_cast<float>(relative));
    }
    void add(const TraceAgreement& other) {
        rays += other.rays;
        hits += other.hits;
        different += other.different;
        unexplained += other.unexplained;
        close += other.close;
        misplaced += other.misplaced;
        relative_t.insert(relative_t.end(), other.relative_t.begin(), other.relative_t.end());
    }
    /// The relative difference of t that a share of the rays keeps to.
    [[nodiscard]] double quantile(double share) {
        if (relative_t.empty()) return 0;
        const auto at = relative_t.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(relative_t.size() - 1));
        std::nth_element(relative_t.begin(), at, relative_t.end());
        return double{*at};
    }
};

}  // namespace tedavis::test_support
