/// Rays in the compiler's vectors of N floats (scalar_lanes.hpp describes lane types): SSE and NEON with 4, AVX2 with 8.
#pragma once

#include "render_core/raytrace/lanes/scalar_lanes.hpp"

namespace tedavis::raytrace {

template <int N>
struct VectorOf;
template <>
struct VectorOf<4> {
    typedef float Float __attribute__((vector_size(16)));
    typedef std::int32_t Int __attribute__((vector_size(16)));
};
template <>
struct VectorOf<8> {
    typedef float Float __attribute__((vector_size(32)));
    typedef std::int32_t Int __attribute__((vector_size(32)));
};

template <int N>
struct VectorLanes {
    static constexpr int kCount = N;
    using Narrow = VectorLanes;

    using FloatVector = typename VectorOf<N>::Float;
    using IntVector = typename VectorOf<N>::Int;

    // NOLINTBEGIN(bugprone-macro-parentheses): types
#define TEDAVIS_VECTOR(result, type, op) \
    friend __attribute__((always_inline)) inline result operator op(type a, type b) { return result{a.v op b.v}; }
    // NOLINTEND(bugprone-macro-parentheses)
    struct Mask {
        IntVector v;  ///< -1 or 0
        TEDAVIS_VECTOR(Mask, Mask, &)
        TEDAVIS_VECTOR(Mask, Mask, |)
    };
    struct Float {
        FloatVector v;
        Float() = default;
        __attribute__((always_inline)) Float(FloatVector a) : v(a) {}
        __attribute__((always_inline)) Float(float a) : v(a - FloatVector{}) {}
        TEDAVIS_VECTOR(Float, Float, +)
        TEDAVIS_VECTOR(Float, Float, -)
        TEDAVIS_VECTOR(Float, Float, *)
        TEDAVIS_VECTOR(Float, Float, /)
        TEDAVIS_VECTOR(Mask, Float, <)
        TEDAVIS_VECTOR(Mask, Float, <=)
        TEDAVIS_VECTOR(Mask, Float, >)
        TEDAVIS_VECTOR(Mask, Float, >=)
    };
    struct Int {
        IntVector v;
        Int() = default;
        __attribute__((always_inline)) Int(IntVector a) : v(a) {}
        __attribute__((always_inline)) Int(std::int32_t a) : v(a - IntVector{}) {}
        TEDAVIS_VECTOR(Int, Int, +)
        TEDAVIS_VECTOR(Int, Int, -)
        TEDAVIS_VECTOR(Int, Int, *)
        TEDAVIS_VECTOR(Int, Int, &)
        TEDAVIS_VECTOR(Int, Int, |)
        TEDAVIS_VECTOR(Int, Int, ^)
        TEDAVIS_VECTOR(Int, Int, <<)
        TEDAVIS_VECTOR(Int, Int, >>)
        TEDAVIS_VECTOR(Mask, Int, ==)
        TEDAVIS_VECTOR(Mask, Int, <)
        TEDAVIS_VECTOR(Mask, Int, >)
        TEDAVIS_VECTOR(Mask, Int, >=)
    };
#undef TEDAVIS_VECTOR

    TEDAVIS_LANES_INLINE Float load(const float* from) {
        Float a;
        __builtin_memcpy(&a.v, from, sizeof a.v);
        return a;
    }
    TEDAVIS_LANES_INLINE Int load(const std::int32_t* from) {
        Int a;
        __builtin_memcpy(&a.v, from, sizeof a.v);
        return a;
    }
    TEDAVIS_LANES_INLINE void store(float* to, Float a) { __builtin_memcpy(to, &a.v, sizeof a.v); }
    TEDAVIS_LANES_INLINE void store(std::int32_t* to, Int a) { __builtin_memcpy(to, &a.v, sizeof a.v); }
    TEDAVIS_LANES_INLINE Mask mask(std::uint32_t bits) {
        Mask m;
        for (int n = 0; n < N; ++n) m.v[n] = (bits >> n & 1) != 0 ? -1 : 0;
        return m;
    }
    TEDAVIS_LANES_INLINE std::uint32_t bits(Mask m) {
        std::uint32_t all = 0;
        for (int n = 0; n < N; ++n) all |= (m.v[n] != 0 ? 1u : 0u) << n;
        return all;
    }
    TEDAVIS_LANES_INLINE bool any(Mask m) {
        std::uint64_t parts[N / 2], all = 0;
        __builtin_memcpy(parts, &m.v, sizeof m.v);
        for (const std::uint64_t part : parts) all |= part;
        return all != 0;
    }
    TEDAVIS_LANES_INLINE Mask without(Mask a, Mask b) { return {a.v & ~b.v}; }

    TEDAVIS_LANES_INLINE Float select(Mask m, Float a, Float b) { return Float(m.v ? a.v : b.v); }
    TEDAVIS_LANES_INLINE Int select(Mask m, Int a, Int b) { return Int(m.v ? a.v : b.v); }
    TEDAVIS_LANES_INLINE Float min(Float a, Float b) { return Float(a.v < b.v ? a.v : b.v); }
    TEDAVIS_LANES_INLINE Float max(Float a, Float b) { return Float(a.v > b.v ? a.v : b.v); }
    TEDAVIS_LANES_INLINE Int min(Int a, Int b) { return Int(a.v < b.v ? a.v : b.v); }
    TEDAVIS_LANES_INLINE Int max(Int a, Int b) { return Int(a.v > b.v ? a.v : b.v); }
    TEDAVIS_LANES_INLINE float least(Float a) {
        float all = a.v[0];
        for (int n = 1; n < N; ++n) all = a.v[n] < all ? a.v[n] : all;
        return all;
    }
    TEDAVIS_LANES_INLINE float most(Float a) {
        float all = a.v[0];
        for (int n = 1; n < N; ++n) all = a.v[n] > all ? a.v[n] : all;
        return all;
    }
    TEDAVIS_LANES_INLINE Float sqrt(Float a) {
        for (int n = 0; n < N; ++n) a.v[n] = __builtin_sqrtf(a.v[n]);
        return a;
    }
    TEDAVIS_LANES_INLINE Float to_float(Int a) { return Float(__builtin_convertvector(a.v, FloatVector)); }
    TEDAVIS_LANES_INLINE Int floor_to_int(Float a) {
        const IntVector whole = __builtin_convertvector(a.v, IntVector);
        return Int(whole + (__builtin_convertvector(whole, FloatVector) > a.v));
    }
    TEDAVIS_LANES_INLINE Int look_up(const std::int32_t (&table)[16], Int index) {
        for (int n = 0; n < N; ++n) index.v[n] = table[index.v[n]];
        return index;
    }
    TEDAVIS_LANES_INLINE Int gather(const std::int16_t* from, Int index, Mask m) {
        for (int n = 0; n < N; ++n) index.v[n] = m.v[n] != 0 ? from[index.v[n]] : 0;
        return index;
    }
    TEDAVIS_LANES_INLINE Float gather(const float* from, Int index, Mask m) {
        Float a;
        for (int n = 0; n < N; ++n) a.v[n] = m.v[n] != 0 ? from[index.v[n]] : 0;
        return a;
    }
    template <class Height, class Wide>
    TEDAVIS_LANES_INLINE void gather_two(const Height* from, Int index, Mask m, Wide& first, Wide& second) {
        first = gather(from, index, m);
        second = gather(from + 1, index, m);
    }
    TEDAVIS_LANES_INLINE void scatter(float* to, Int index, Float value, Mask m) {
        for (int n = 0; n < N; ++n)
            if (m.v[n] != 0) to[index.v[n]] = value.v[n];
    }
    TEDAVIS_LANES_INLINE void scatter(std::int32_t* to, Int index, Int value, Mask m) {
        for (int n = 0; n < N; ++n)
            if (m.v[n] != 0) to[index.v[n]] = value.v[n];
    }
};

}  // namespace tedavis::raytrace
