/// How sure a value is: one level from 0, certain, to 1, and unknown, which is never taken for certain.
///
/// Whatever a source states (standard deviation, interval, percent, class), the desk divides by the attribute's full scale, the
/// uncertainty that counts as 1; the legend gives it back in its unit. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <type_traits>

#include "render_core/base/time.hpp"

namespace tedavis::scene {

/// What a source means by its uncertainty.
enum class UncertaintyKind : std::uint8_t { none, standard_deviation, interval, percent, ordinal };
/// What it holds for.
enum class UncertaintyScope : std::uint8_t { value, point, attribute, data_set };
/// Where a value comes from.
enum class ValueState : std::uint8_t { valid, interpolated, missing };

/// A level in a byte: 0..254 are 0..1, and 255 is unknown.
class Uncertainty {
public:
    static constexpr std::uint8_t kUnknown = 255;
    static constexpr std::uint8_t kFull = 254;

    constexpr Uncertainty() = default;  ///< unknown
    [[nodiscard]] static constexpr Uncertainty from_code(std::uint8_t code) { return Uncertainty(code); }
    /// Rounded up, so that nothing looks more certain than it is; above 1 it is 1, below 0 and NaN unknown.
    [[nodiscard]] static Uncertainty from_level(double level) noexcept;

    [[nodiscard]] constexpr bool is_known() const { return code_ != kUnknown; }
    [[nodiscard]] constexpr std::uint8_t code() const { return code_; }
    /// 0..1; 1 where it is unknown.
    [[nodiscard]] constexpr double level() const { return is_known() ? code_ / double{kFull} : 1.0; }

    friend constexpr bool operator==(Uncertainty a, Uncertainty b) { return a.code_ == b.code_; }
    friend constexpr bool operator!=(Uncertainty a, Uncertainty b) { return a.code_ != b.code_; }

private:
    explicit constexpr Uncertainty(std::uint8_t code) : code_(code) {}

    std::uint8_t code_ = kUnknown;
};
static_assert(std::is_trivially_copyable_v<Uncertainty> && sizeof(Uncertainty) == 1);

/// Of a value as old as `age`: the level grows by growth_per_hour each hour, at most to 1. Negative ages count like positive ones
/// (a forecast is the less sure the farther off it is); a growth that is negative or NaN makes it unknown.
[[nodiscard]] Uncertainty aged(Uncertainty uncertainty, base::Duration age, double growth_per_hour) noexcept;

/// Of a value between others: not below the least sure of those that have weight, and unknown when one of these is.
[[nodiscard]] Uncertainty worse(Uncertainty a, Uncertainty b) noexcept;

}  // namespace tedavis::scene
