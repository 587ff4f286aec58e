/// The answers of a height query at the places that were asked for last. What stands on the ground is asked for at every decision
/// interval, and its places lie in more chunks than a query keeps: without this each of them is read and verified again.
///
/// Memory  from the arena at start(). Thread  one.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/terrain/height_answer.hpp"

namespace tedavis::terrain {

class KeptHeights {
public:
    static constexpr std::uint32_t kSets = 512, kWays = 4;  ///< a place has its answer in one of the ways of its set

    /// False where the arena is too small.
    [[nodiscard]] bool start(base::Arena& arena);
    /// The answer that is kept for exactly this place, valid until the next keep(); null: none.
    [[nodiscard]] const HeightAnswer* find(double latitude_rad, double longitude_rad);
    /// In the place of the answer of its set that was asked for least recently.
    void keep(double latitude_rad, double longitude_rad, const HeightAnswer& answer);
    [[nodiscard]] static std::uint64_t bytes_needed() { return kSets * kWays * sizeof(Kept) + alignof(Kept); }

private:
    struct Kept {
        double latitude_rad, longitude_rad;
        HeightAnswer answer;
        std::uint64_t asked;  ///< 0: empty
    };
    [[nodiscard]] base::Span<Kept> set_of(double latitude_rad, double longitude_rad) const;

    base::Span<Kept> kept_;
    std::uint64_t asked_ = 0;
};

}  // namespace tedavis::terrain
