/// A grid field, or one member of its ensemble, at one height and time as texels, for colour on the ground. Texels are computed
/// a few rows at a time, so that a change of time or height does not delay a frame.
///
/// A texel is a post: its value in 16 bits between the attribute's limits (finer than any step of a colour scale), its
/// uncertainty (Uncertainty::code) and its state.
/// Memory    the texels belong to the caller. Thread  one.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/scene/grid_field.hpp"

namespace tedavis::scene {

struct SliceTexel {
    std::uint8_t value_high = 0, value_low = 0;
    std::uint8_t uncertainty = Uncertainty::kUnknown;
    std::uint8_t state = 0;  ///< 255 valid, 128 interpolated, 0 missing
};
static_assert(sizeof(SliceTexel) == 4);

/// The range of texel values: value = lowest + (high * 256 + low) / 65535 * (highest - lowest).
struct SliceRange {
    double lowest = 0, highest = 0;
};

/// Encodes one value. An empty range gives 0.
[[nodiscard]] SliceTexel texel_of(const FieldValue& value, const SliceRange& range) noexcept;
[[nodiscard]] double value_of(const SliceTexel& texel, const SliceRange& range) noexcept;

/// Used instead of a member's number: the mean.
inline constexpr std::uint32_t kMean = UINT32_MAX;

/// The height, time and member of a field that are shown.
struct SliceMoment {
    double height_m = 0;
    std::int64_t time_ns = 0;
    std::uint32_t member = kMean;  ///< below the attribute's member_count()

    friend bool operator==(const SliceMoment& a, const SliceMoment& b) {
        return a.height_m == b.height_m && a.time_ns == b.time_ns && a.member == b.member;
    }
};

class GridSlice {
public:
    /// Bytes for grids of up to `most_posts` posts in a slice.
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t most_posts);
    [[nodiscard]] bool start(std::uint32_t most_posts, base::Arena& arena);

    /// Sets the field. Returns false where the layer is not a grid or has more posts than there is room for. Layer and
    /// attribute must stay valid until forget() is called or the slice is destroyed.
    [[nodiscard]] bool set_field(const Layer& layer, const Attribute& attribute);
    void forget();
    /// Computes the slice of a moment; to be called after set_field(). Returns true when the texels have changed.
    [[nodiscard]] bool show(const SliceMoment& moment);
    /// Computes at most `rows` further rows of the slice that show() will need next.
    void prepare(const SliceMoment& moment, std::uint32_t rows);

    [[nodiscard]] bool has_texels() const { return shown_.is_whole(rows()); }
    [[nodiscard]] std::uint32_t columns() const { return layer_ == nullptr ? 0 : layer_->entry->grid.columns; }
    [[nodiscard]] std::uint32_t rows() const { return layer_ == nullptr ? 0 : layer_->entry->grid.rows; }
    /// The texels of the slice shown last, row by row from the north-west.
    [[nodiscard]] base::Span<const SliceTexel> texels() const { return {shown_.texels.data(), std::size_t{columns()} * rows()}; }
    [[nodiscard]] SliceRange range() const;
    /// Bit n: a post of the slice shown last is of class n. 0 for quantitative attributes.
    [[nodiscard]] std::uint32_t classes_in_use() const { return shown_.classes; }
    [[nodiscard]] const Layer* layer() const { return layer_; }
    [[nodiscard]] const Attribute* attribute() const { return attribute_; }

private:
    struct Sheet {
        base::Span<SliceTexel> texels;
        SliceMoment moment;
        std::uint32_t rows = 0;     ///< rows computed so far
        std::uint32_t classes = 0;  ///< classes in these rows, one bit each
        bool is_begun = false;

        [[nodiscard]] bool is_whole(std::uint32_t all) const { return is_begun && rows == all; }
        [[nodiscard]] bool is_of(const SliceMoment& other) const { return is_begun && moment == other; }
        void begin(const SliceMoment& other);
    };
    void make(Sheet& sheet, std::uint32_t most_rows) const;

    const Layer* layer_ = nullptr;
    const Attribute* attribute_ = nullptr;
    Sheet shown_, next_;
};

}  // namespace tedavis::scene
