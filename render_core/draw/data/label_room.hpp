/// The boxes that labels have taken, indexed by the part of the screen in which they lie. Exact. Memory  its own 12 KiB, for
/// the time of a decision. Pure; any thread.
#pragma once

#include <array>
#include <cstdint>

#include "render_core/draw/rect.hpp"

namespace tedavis::draw {

class LabelRoom {
public:
    static constexpr std::size_t kMax = 255;

    explicit LabelRoom(const Rect& screen) : screen_(screen) {}
    /// Takes a box; boxes beyond kMax are refused.
    void take(const Rect& box);
    /// True where a box overlaps none of the taken boxes, except box `except` and those that overlap it.
    [[nodiscard]] bool is_free(const Rect& box, std::size_t except = kMax) const;
    [[nodiscard]] bool is_empty() const { return count_ == 0; }

private:
    static constexpr std::size_t kParts = 16;
    using Set = std::array<std::uint64_t, 4>;  ///< one bit per box

    /// A range of parts of the screen, first and last included, both within 0 .. kParts - 1.
    struct Parts {
        std::size_t left, top, right, bottom;
    };
    [[nodiscard]] bool is_beside(std::size_t n, std::size_t other) const;
    [[nodiscard]] Parts parts_of(const Rect& box) const;

    Rect screen_;
    std::array<Rect, kMax> boxes_;
    std::array<Set, kParts * kParts> sets_{};
    std::size_t count_ = 0;
};

}  // namespace tedavis::draw
