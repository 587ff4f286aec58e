/// The key: in flight, the scales of a frame that do not explain themselves, each as a title over its colours with two numbers.
///
/// Symbols, names of classes, uncertainty and sources are only in the whole legend. Pure: no GL, no clock, no heap. Thread any.
#pragma once

#include "render_core/base/fixed_vector.hpp"
#include "render_core/draw/symbology/painter.hpp"

namespace tedavis::draw {

inline constexpr std::size_t kMaxKeyEntries = kMaxDataLegends + 2;
inline constexpr std::size_t kKeySlices = 16;  ///< number of slices of a scale without classes

/// A title, and colours from the lowest value to the highest with numbers between two of them.
struct KeyEntry {
    base::FixedVector<base::FixedString<47>, 4> titles;  ///< from the longest to the shortest
    base::FixedVector<design::Color, design::kMaxClasses + kKeySlices> colors;
    /// The numbers, and how many colours stand before each.
    struct Number {
        ShortText text;
        std::size_t after = 0;
    };
    base::FixedVector<Number, 2> numbers;
    bool is_amber = false;  ///< the data are stale, or their age is not known
    int rank = 0;           ///< entries of a higher rank are left out first
};
using KeyEntries = base::FixedVector<KeyEntry, kMaxKeyEntries>;

/// The entries of a frame, the most important first: a member that is shown in turn with others, warning bands, stale data, other
/// data, the terrain. Where no legend is shown only the first kind is left.
[[nodiscard]] KeyEntries key_entries(const SymbologyInput& input) noexcept;

/// Draws the entries for which the layout has cells.
void build_key(const Painter& painter, const SymbologyInput& input);

}  // namespace tedavis::draw
