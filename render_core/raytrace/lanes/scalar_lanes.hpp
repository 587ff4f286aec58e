/// One ray at a time with the interface of the wider lane types, for machines without them.
///
/// A lane type has Float, Int (32 bits) and Mask with the usual operators, and the functions below. Every operation is one IEEE
/// operation per lane, so all lane types give the same bits. Shifts of Int are arithmetic.
#pragma once

#include <cstdint>

#define TEDAVIS_LANES_INLINE static inline __attribute__((always_inline))
#define TEDAVIS_LANES_LAMBDA __attribute__((always_inline))

namespace tedavis::raytrace {

struct ScalarLanes {
    static constexpr int kCount = 1;
    using Narrow = ScalarLanes;  ///< lane type for fewer than kCount lanes
    using Float = float;
    using Int = std::int32_t;
    using Mask = bool;

    TEDAVIS_LANES_INLINE Float load(const float* from) { return *from; }
    TEDAVIS_LANES_INLINE Int load(const std::int32_t* from) { return *from; }
    TEDAVIS_LANES_INLINE void store(float* to, Float value) { *to = value; }
    TEDAVIS_LANES_INLINE void store(std::int32_t* to, Int value) { *to = value; }
    /// Bit n of `bits` is lane n.
    TEDAVIS_LANES_INLINE Mask mask(std::uint32_t bits) { return (bits & 1) != 0; }
    TEDAVIS_LANES_INLINE std::uint32_t bits(Mask m) { return m ? 1 : 0; }
    TEDAVIS_LANES_INLINE bool any(Mask m) { return m; }
    TEDAVIS_LANES_INLINE Mask without(Mask a, Mask b) { return a && !b; }

    TEDAVIS_LANES_INLINE Float select(Mask m, Float a, Float b) { return m ? a : b; }
    TEDAVIS_LANES_INLINE Int select(Mask m, Int a, Int b) { return m ? a : b; }
    TEDAVIS_LANES_INLINE Float min(Float a, Float b) { return a < b ? a : b; }
    TEDAVIS_LANES_INLINE Float max(Float a, Float b) { return a > b ? a : b; }
    TEDAVIS_LANES_INLINE Int min(Int a, Int b) { return a < b ? a : b; }
    TEDAVIS_LANES_INLINE Int max(Int a, Int b) { return a > b ? a : b; }
    TEDAVIS_LANES_INLINE float least(Float a) { return a; }
    TEDAVIS_LANES_INLINE float most(Float a) { return a; }
    TEDAVIS_LANES_INLINE Float sqrt(Float a) { return __builtin_sqrtf(a); }
    TEDAVIS_LANES_INLINE Float to_float(Int a) { return static_cast<float>(a); }
    /// For values between -2^31 and 2^31.
    TEDAVIS_LANES_INLINE Int floor_to_int(Float a) {
        const auto whole = static_cast<std::int32_t>(a);
        return whole - (static_cast<float>(whole) > a ? 1 : 0);
    }
    TEDAVIS_LANES_INLINE Int look_up(const std::int32_t (&table)[16], Int index) { return table[index]; }

    template <class Height>
    TEDAVIS_LANES_INLINE auto gather(const Height* from, Int index, Mask m) {
        return m ? widened(from[index]) : widened(Height{0});
    }
    /// Also reads the element behind it.
    template <class Height, class Wide>
    TEDAVIS_LANES_INLINE void gather_two(const Height* from, Int index, Mask m, Wide& first, Wide& second) {
        first = m ? widened(from[index]) : Wide{0};
        second = m ? widened(from[index + 1]) : Wide{0};
    }
    /// No two lanes may have the same index.
    template <class Value>
    TEDAVIS_LANES_INLINE void scatter(Value* to, Int index, Value value, Mask m) {
        if (m) to[index] = value;
    }

private:
    TEDAVIS_LANES_INLINE Int widened(std::int16_t a) { return a; }
    TEDAVIS_LANES_INLINE Float widened(float a) { return a; }
};

}  // namespace tedavis::raytrace
