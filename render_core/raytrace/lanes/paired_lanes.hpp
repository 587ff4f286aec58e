/// Two vectors of another lane type used as one: while one half waits for memory or latency, the other one computes.
#pragma once

#include "render_core/raytrace/lanes/scalar_lanes.hpp"

namespace tedavis::raytrace {

template <class V>
struct PairedLanes {
    static constexpr int kCount = 2 * V::kCount;
    using Narrow = V;

    // NOLINTBEGIN(bugprone-macro-parentheses): types
#define TEDAVIS_PAIRED(result, type, op) \
    friend __attribute__((always_inline)) inline result operator op(type a, type b) { return {a.low op b.low, a.high op b.high}; }
    // NOLINTEND(bugprone-macro-parentheses)
    struct Mask {
        typename V::Mask low, high;
        TEDAVIS_PAIRED(Mask, Mask, &)
        TEDAVIS_PAIRED(Mask, Mask, |)
    };
    struct Float {
        typename V::Float low, high;
        Float() = default;
        __attribute__((always_inline)) Float(typename V::Float a, typename V::Float b) : low(a), high(b) {}
        __attribute__((always_inline)) Float(float a) : low(a), high(a) {}
        TEDAVIS_PAIRED(Float, Float, +)
        TEDAVIS_PAIRED(Float, Float, -)
        TEDAVIS_PAIRED(Float, Float, *)
        TEDAVIS_PAIRED(Float, Float, /)
        TEDAVIS_PAIRED(Mask, Float, <)
        TEDAVIS_PAIRED(Mask, Float, <=)
        TEDAVIS_PAIRED(Mask, Float, >)
        TEDAVIS_PAIRED(Mask, Float, >=)
    };
    struct Int {
        typename V::Int low, high;
        Int() = default;
        __attribute__((always_inline)) Int(typename V::Int a, typename V::Int b) : low(a), high(b) {}
        __attribute__((always_inline)) Int(std::int32_t a) : low(a), high(a) {}
        TEDAVIS_PAIRED(Int, Int, +)
        TEDAVIS_PAIRED(Int, Int, -)
        TEDAVIS_PAIRED(Int, Int, *)
        TEDAVIS_PAIRED(Int, Int, &)
        TEDAVIS_PAIRED(Int, Int, |)
        TEDAVIS_PAIRED(Int, Int, ^)
        TEDAVIS_PAIRED(Int, Int, <<)
        TEDAVIS_PAIRED(Int, Int, >>)
        TEDAVIS_PAIRED(Mask, Int, ==)
        TEDAVIS_PAIRED(Mask, Int, <)
        TEDAVIS_PAIRED(Mask, Int, >)
        TEDAVIS_PAIRED(Mask, Int, >=)
    };
#undef TEDAVIS_PAIRED

    TEDAVIS_LANES_INLINE Float load(const float* from) { return {V::load(from), V::load(from + V::kCount)}; }
    TEDAVIS_LANES_INLINE Int load(const std::int32_t* from) { return {V::load(from), V::load(from + V::kCount)}; }
    TEDAVIS_LANES_INLINE void store(float* to, Float a) {
        V::store(to, a.low);
        V::store(to + V::kCount, a.high);
    }
    TEDAVIS_LANES_INLINE void store(std::int32_t* to, Int a) {
        V::store(to, a.low);
        V::store(to + V::kCount, a.high);
    }
    TEDAVIS_LANES_INLINE Mask mask(std::uint32_t bits) { return {V::mask(bits), V::mask(bits >> V::kCount)}; }
    TEDAVIS_LANES_INLINE std::uint32_t bits(Mask m) { return V::bits(m.low) | V::bits(m.high) << V::kCount; }
    TEDAVIS_LANES_INLINE bool any(Mask m) { return V::any(m.low | m.high); }
    TEDAVIS_LANES_INLINE Mask without(Mask a, Mask b) { return {V::without(a.low, b.low), V::without(a.high, b.high)}; }

    TEDAVIS_LANES_INLINE Float select(Mask m, Float a, Float b) {
        return {V::select(m.low, a.low, b.low), V::select(m.high, a.high, b.high)};
    }
    TEDAVIS_LANES_INLINE Int select(Mask m, Int a, Int b) {
        return {V::select(m.low, a.low, b.low), V::select(m.high, a.high, b.high)};
    }
    TEDAVIS_LANES_INLINE Float min(Float a, Float b) { return {V::min(a.low, b.low), V::min(a.high, b.high)}; }
    TEDAVIS_LANES_INLINE Float max(Float a, Float b) { return {V::max(a.low, b.low), V::max(a.high, b.high)}; }
    TEDAVIS_LANES_INLINE Int min(Int a, Int b) { return {V::min(a.low, b.low), V::min(a.high, b.high)}; }
    TEDAVIS_LANES_INLINE Int max(Int a, Int b) { return {V::max(a.low, b.low), V::max(a.high, b.high)}; }
    TEDAVIS_LANES_INLINE float least(Float a) { return V::least(V::min(a.low, a.high)); }
    TEDAVIS_LANES_INLINE float most(Float a) { return V::most(V::max(a.low, a.high)); }
    TEDAVIS_LANES_INLINE Float sqrt(Float a) { return {V::sqrt(a.low), V::sqrt(a.high)}; }
    TEDAVIS_LANES_INLINE Float to_float(Int a) { return {V::to_float(a.low), V::to_float(a.high)}; }
    TEDAVIS_LANES_INLINE Int floor_to_int(Float a) { return {V::floor_to_int(a.low), V::floor_to_int(a.high)}; }
    TEDAVIS_LANES_INLINE Int look_up(const std::int32_t (&table)[16], Int index) {
        return {V::look_up(table, index.low), V::look_up(table, index.high)};
    }
    TEDAVIS_LANES_INLINE Int gather(const std::int16_t* from, Int index, Mask m) {
        return {V::gather(from, index.low, m.low), V::gather(from, index.high, m.high)};
    }
    TEDAVIS_LANES_INLINE Float gather(const float* from, Int index, Mask m) {
        return {V::gather(from, index.low, m.low), V::gather(from, index.high, m.high)};
    }
    template <class Height, class Wide>
    TEDAVIS_LANES_INLINE void gather_two(const Height* from, Int index, Mask m, Wide& first, Wide& second) {
        V::gather_two(from, index.low, m.low, first.low, second.low);
        V::gather_two(from, index.high, m.high, first.high, second.high);
    }
    TEDAVIS_LANES_INLINE void scatter(float* to, Int index, Float value, Mask m) {
        V::scatter(to, index.low, value.low, m.low);
        V::scatter(to, index.high, value.high, m.high);
    }
    TEDAVIS_LANES_INLINE void scatter(std::int32_t* to, Int index, Int value, Mask m) {
        V::scatter(to, index.low, value.low, m.low);
        V::scatter(to, index.high, value.high, m.high);
    }
};

}  // namespace tedavis::raytrace
