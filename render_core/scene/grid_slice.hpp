/// A grid field, or one member of its ensemble, at one height and one time as texels, for colour on the ground: made a few rows
/// at a time, so that a change of time or of height stalls no frame.
///
/// A texel is a post: its value in 16 bits between the attribute's limits (a 65,535th of them is less than any step of a colour
/// scale shows), its uncertainty (Uncertainty::code) and its state.
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

/// What texels stand for: value = lowest + (high * 256 + low) / 65535 * (highest - lowest).
struct SliceRange {
    double lowest = 0, highest = 0;
};

/// Of one value. A range of nothing gives 0.
[[nodiscard]] SliceTexel texel_of(const FieldValue& value, const SliceRange& range) noexcept;
[[nodiscard]] double value_of(const SliceTexel& texel, const SliceRange& range) noexcept;

/// In place of a member's number.
inline constexpr std::uint32_t kMean = UINT32_MAX;

/// What of a field is shown.
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
    /// Room for grids of `most_posts` in one slice.
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t most_posts);
    [[nodiscard]] bool start(std::uint32_t most_posts, base::Arena& arena);

    /// What is to be seen. False where the layer is no grid, or has more posts than there is room for. Layer and attribute must
    /// outlive the slice, or forget() be called.
    [[nodiscard]] bool set_field(const Layer& layer, const Attribute& attribute);
    void forget();
    /// The slice of a moment; after set_field(). True when the texels are others than before.
    [[nodiscard]] bool show(const SliceMoment& moment);
    /// Goes on with at most `rows` rows of the slice that show() will ask for next.
    void prepare(const SliceMoment& moment, std::uint32_t rows);

    [[nodiscard]] bool has_texels() const { return shown_.is_whole(rows()); }
    [[nodiscard]] std::uint32_t columns() const { return layer_ == nullptr ? 0 : layer_->entry->grid.columns; }
    [[nodiscard]] std::uint32_t rows() const { return layer_ == nullptr ? 0 : layer_->entry->grid.rows; }
    /// Row by row from the north-west; of the slice that was shown last.
    [[nodiscard]] base::Span<const SliceTexel> texels() const { return {shown_.texels.data(), std::size_t{columns()} * rows()}; }
    [[nodiscard]] SliceRange range() const;
    /// Bit n: some post of the slice that was shown last is of class n. 0 of quantities.
    [[nodiscard]] std::uint32_t classes_in_use() const { return shown_.classes; }
    [[nodiscard]] const Layer* layer() const { return layer_; }
    [[nodiscard]] const Attribute* attribute() const { return attribute_; }

private:
    struct Sheet {
        base::Span<SliceTexel> texels;
        SliceMoment moment;
        std::uint32_t rows = 0;     ///< that are made
        std::uint32_t classes = 0;  ///< a bit each, in these rows
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
