/// The uncertainty of a value: a level from 0 (certain) to 1, or unknown, which is never treated as certain.
///
/// The scene builder divides what a source states (standard deviation, interval, percent, class) by the attribute's full scale,
/// the uncertainty that counts as level 1; the legend shows it in the source's unit. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <type_traits>

#include "render_core/base/time.hpp"

namespace tedavis::scene {

/// The kind of uncertainty that a source states.
enum class UncertaintyKind : std::uint8_t { none, standard_deviation, interval, percent, ordinal };
/// What a stated uncertainty applies to.
enum class UncertaintyScope : std::uint8_t { value, point, attribute, data_set };
/// The origin of a value.
enum class ValueState : std::uint8_t { valid, interpolated, missing };

/// A level in one byte: codes 0..254 stand for 0..1, and 255 is unknown.
class Uncertainty {
public:
    static constexpr std::uint8_t kUnknown = 255;
    static constexpr std::uint8_t kFull = 254;

    constexpr Uncertainty() = default;  ///< unknown
    [[nodiscard]] static constexpr Uncertainty from_code(std::uint8_t code) { return Uncertainty(code); }
    /// Rounds a level up, so that no value looks more certain than it is. Levels above 1 count as 1, those below 0 and NaN as
    /// unknown.
    [[nodiscard]] static Uncertainty from_level(double level) noexcept;

    [[nodiscard]] constexpr bool is_known() const { return code_ != kUnknown; }
    [[nodiscard]] constexpr std::uint8_t code() const { return code_; }
    /// The level 0..1; 1 where it is unknown.
    [[nodiscard]] constexpr double level() const { return is_known() ? code_ / double{kFull} : 1.0; }

    friend constexpr bool operator==(Uncertainty a, Uncertainty b) { return a.code_ == b.code_; }
    friend constexpr bool operator!=(Uncertainty a, Uncertainty b) { return a.code_ != b.code_; }

private:
    explicit constexpr Uncertainty(std::uint8_t code) : code_(code) {}

    std::uint8_t code_ = kUnknown;
};
static_assert(std::is_trivially_copyable_v<Uncertainty> && sizeof(Uncertainty) == 1);

/// Returns the uncertainty at an age: the level grows by growth_per_hour each hour, at most to 1. Negative ages count like
/// positive ones (a forecast is less certain the farther ahead it is); a negative growth or NaN makes it unknown.
[[nodiscard]] Uncertainty aged(Uncertainty uncertainty, base::Duration age, double growth_per_hour) noexcept;

/// Returns the greater uncertainty of two; unknown where one of them is.
[[nodiscard]] Uncertainty worse(Uncertainty a, Uncertainty b) noexcept;

}  // namespace tedavis::scene
