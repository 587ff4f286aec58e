/// Sixteen rays at a time (scalar_lanes.hpp describes lane types). Only for sources that are compiled for AVX-512 F, BW, DQ,
/// VL.
#pragma once

#include <immintrin.h>

#include "render_core/raytrace/lanes/scalar_lanes.hpp"

namespace tedavis::raytrace {

struct Avx512Lanes {
    static constexpr int kCount = 16;
    using Narrow = Avx512Lanes;

    struct Mask {
        __mmask16 v;
        friend __attribute__((always_inline)) inline Mask operator&(Mask a, Mask b) {
            return {static_cast<__mmask16>(a.v & b.v)};
        }
        friend __attribute__((always_inline)) inline Mask operator|(Mask a, Mask b) {
            return {static_cast<__mmask16>(a.v | b.v)};
        }
    };
    struct Float {
        __m512 v;
        Float() = default;
        __attribute__((always_inline)) Float(__m512 a) : v(a) {}
        __attribute__((always_inline)) Float(float a) : v(_mm512_set1_ps(a)) {}
        friend __attribute__((always_inline)) inline Float operator+(Float a, Float b) { return _mm512_add_ps(a.v, b.v); }
        friend __attribute__((always_inline)) inline Float operator-(Float a, Float b) { return _mm512_sub_ps(a.v, b.v); }
        friend __attribute__((always_inline)) inline Float operator*(Float a, Float b) { return _mm512_mul_ps(a.v, b.v); }
        friend __attribute__((always_inline)) inline Float operator/(Float a, Float b) { return _mm512_div_ps(a.v, b.v); }
        friend __attribute__((always_inline)) inline Mask operator<(Float a, Float b) {
            return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ)};
        }
        friend __attribute__((always_inline)) inline Mask operator<=(Float a, Float b) {
            return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ)};
        }
        friend __attribute__((always_inline)) inline Mask operator>(Float a, Float b) {
            return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_GT_OQ)};
        }
        friend __attribute__((always_inline)) inline Mask operator>=(Float a, Float b) {
            return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_GE_OQ)};
        }
    };
    struct Int {
        __m512i v;
        Int() = default;
        __attribute__((always_inline)) Int(__m512i a) : v(a) {}
        __attribute__((always_inline)) Int(std::int32_t a) : v(_mm512_set1_epi32(a)) {}
        friend __attribute__((always_inline)) inline Int operator+(Int a, Int b) { return _mm512_add_epi32(a.v, b.v); }
        friend __attribute__((always_inline)) inline Int operator-(Int a, Int b) { return _mm512_sub_epi32(a.v, b.v); }
        friend __attribute__((always_inline)) inline Int operator*(Int a, Int b) { return _mm512_mullo_epi32(a.v, b.v); }
        friend __attribute__((always_inline)) inline Int operator&(Int a, Int b) { return _mm512_and_si512(a.v, b.v); }
        friend __attribute__((always_inline)) inline Int operator|(Int a, Int b) { return _mm512_or_si512(a.v, b.v); }
        friend __attribute__((always_inline)) inline Int operator^(Int a, Int b) { return _mm512_xor_si512(a.v, b.v); }
        friend __attribute__((always_inline)) inline Int operator<<(Int a, Int b) { return _mm512_sllv_epi32(a.v, b.v); }
        friend __attribute__((always_inline)) inline Int operator>>(Int a, Int b) { return _mm512_srav_epi32(a.v, b.v); }
        friend __attribute__((always_inline)) inline Mask operator==(Int a, Int b) { return {_mm512_cmpeq_epi32_mask(a.v, b.v)}; }
        friend __attribute__((always_inline)) inline Mask operator<(Int a, Int b) { return {_mm512_cmplt_epi32_mask(a.v, b.v)}; }
        friend __attribute__((always_inline)) inline Mask operator>(Int a, Int b) { return {_mm512_cmpgt_epi32_mask(a.v, b.v)}; }
        friend __attribute__((always_inline)) inline Mask operator>=(Int a, Int b) { return {_mm512_cmpge_epi32_mask(a.v, b.v)}; }
    };

    TEDAVIS_LANES_INLINE Float load(const float* from) { return _mm512_loadu_ps(from); }
    TEDAVIS_LANES_INLINE Int load(const std::int32_t* from) { return _mm512_loadu_si512(from); }
    TEDAVIS_LANES_INLINE void store(float* to, Float value) { _mm512_storeu_ps(to, value.v); }
    TEDAVIS_LANES_INLINE void store(std::int32_t* to, Int value) { _mm512_storeu_si512(to, value.v); }
    TEDAVIS_LANES_INLINE Mask mask(std::uint32_t bits) { return {static_cast<__mmask16>(bits)}; }
    TEDAVIS_LANES_INLINE std::uint32_t bits(Mask m) { return m.v; }
    TEDAVIS_LANES_INLINE bool any(Mask m) { return m.v != 0; }
    TEDAVIS_LANES_INLINE Mask without(Mask a, Mask b) { return {static_cast<__mmask16>(a.v & ~b.v)}; }

    TEDAVIS_LANES_INLINE Float select(Mask m, Float a, Float b) { return _mm512_mask_blend_ps(m.v, b.v, a.v); }
    TEDAVIS_LANES_INLINE Int select(Mask m, Int a, Int b) { return _mm512_mask_blend_epi32(m.v, b.v, a.v); }
    TEDAVIS_LANES_INLINE Float min(Float a, Float b) { return _mm512_min_ps(a.v, b.v); }
    TEDAVIS_LANES_INLINE Float max(Float a, Float b) { return _mm512_max_ps(a.v, b.v); }
    TEDAVIS_LANES_INLINE Int min(Int a, Int b) { return _mm512_min_epi32(a.v, b.v); }
    TEDAVIS_LANES_INLINE Int max(Int a, Int b) { return _mm512_max_epi32(a.v, b.v); }
    TEDAVIS_LANES_INLINE float least(Float a) { return _mm512_reduce_min_ps(a.v); }
    TEDAVIS_LANES_INLINE float most(Float a) { return _mm512_reduce_max_ps(a.v); }
    TEDAVIS_LANES_INLINE Float sqrt(Float a) { return _mm512_sqrt_ps(a.v); }
    TEDAVIS_LANES_INLINE Float to_float(Int a) { return _mm512_cvtepi32_ps(a.v); }
    TEDAVIS_LANES_INLINE Int floor_to_int(Float a) {
        return _mm512_cvt_roundps_epi32(a.v, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
    }
    TEDAVIS_LANES_INLINE Int look_up(const std::int32_t (&table)[16], Int index) {
        return _mm512_permutexvar_epi32(index.v, _mm512_loadu_si512(table));
    }

    TEDAVIS_LANES_INLINE Int gather(const std::int16_t* from, Int index, Mask m) { return low_half(pair(from, index, m)); }
    TEDAVIS_LANES_INLINE void gather_two(const std::int16_t* from, Int index, Mask m, Int& first, Int& second) {
        const __m512i both = pair(from, index, m);
        first = low_half(both);
        second = _mm512_srai_epi32(both, 16);
    }
    TEDAVIS_LANES_INLINE Float gather(const float* from, Int index, Mask m) {
        return _mm512_mask_i32gather_ps(_mm512_setzero_ps(), m.v, index.v, from, 4);
    }
    TEDAVIS_LANES_INLINE void gather_two(const float* from, Int index, Mask m, Float& first, Float& second) {
        first = gather(from, index, m);
        second = gather(from + 1, index, m);
    }
    TEDAVIS_LANES_INLINE void scatter(float* to, Int index, Float value, Mask m) {
        _mm512_mask_i32scatter_ps(to, m.v, index.v, value.v, 4);
    }
    TEDAVIS_LANES_INLINE void scatter(std::int32_t* to, Int index, Int value, Mask m) {
        _mm512_mask_i32scatter_epi32(to, m.v, index.v, value.v, 4);
    }

private:
    TEDAVIS_LANES_INLINE __m512i pair(const std::int16_t* from, Int index, Mask m) {
        return _mm512_mask_i32gather_epi32(_mm512_setzero_si512(), m.v, index.v, from, 2);
    }
    TEDAVIS_LANES_INLINE __m512i low_half(__m512i both) { return _mm512_srai_epi32(_mm512_slli_epi32(both, 16), 16); }
};

}  // namespace tedavis::raytrace
