// Arithmetic that others spoil is seen, whatever they did, and is as it was after set_float_environment().
#include "render_core/base/float_environment.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cstdint>
#include <limits>
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "tests/support/contraction/float_probes.hpp"
#include "tests/support/contraction/seams.hpp"
#include "tests/support/files/hard_case.hpp"

namespace tedavis::base::test_float_environment {
namespace {

class FloatEnvironment : public ::testing::Test {
protected:
    FloatEnvironment() { set_float_environment(); }
    ~FloatEnvironment() override { set_float_environment(); }
};

/// Bits of the processor's control register; none where this test does not know it.
void flush_to_zero(bool inputs, bool results) {
#if defined(__SSE2__)
    constexpr unsigned kInputs = 0x0040, kResults = 0x8000;
    _mm_setcsr((_mm_getcsr() & ~(kInputs | kResults)) | (inputs ? kInputs : 0) | (results ? kResults : 0));
#elif defined(__aarch64__)
    constexpr std::uint64_t kBoth = std::uint64_t{1} << 24;
    std::uint64_t control = 0;
    asm volatile("mrs %0, fpcr" : "=r"(control));
    control = inputs || results ? control | kBoth : control & ~kBoth;
    asm volatile("msr fpcr, %0" : : "r"(control));
#elif defined(__arm__)
    constexpr std::uint32_t kBoth = std::uint32_t{1} << 24;
    std::uint32_t control = 0;
    asm volatile("vmrs %0, fpscr" : "=r"(control));
    control = inputs || results ? control | kBoth : control & ~kBoth;
    asm volatile("vmsr fpscr, %0" : : "r"(control));
#else
    (void)inputs, (void)results;
#endif
}

constexpr bool kKnowsControl =
#if defined(__SSE2__) || defined(__aarch64__) || defined(__arm__)
    true;
#else
    false;
#endif

TEST_F(FloatEnvironment, IsWholeInThisBuild) {
    EXPECT_EQ(float_fault(), FloatFault::none);
    EXPECT_EQ(words_of(float_fault()), "arithmetic is that of IEEE 754");
}

TEST_F(FloatEnvironment, OtherRoundingIsSeenAndSetBack) {
    int missed = 0;
    for (const int rounding : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        ASSERT_EQ(std::fesetround(rounding), 0);
        const FloatFault found = float_fault();
        set_float_environment();
        if (found != FloatFault::rounding) ++missed;
        EXPECT_EQ(float_fault(), FloatFault::none);
        EXPECT_EQ(std::fegetround(), FE_TONEAREST);
    }
    EXPECT_EQ(missed, 0);
    test_support::record_worst("A48", missed);
}

/// Without the check the state stays: 1, or -1, plus a part of its last place is another number.
TEST_F(FloatEnvironment, OtherRoundingChangesSumsWhereNobodyLooks) {
    const volatile double one = 1, step = std::numeric_limits<double>::epsilon();
    const auto sums_differ = [&](int rounding) {
        const volatile double up = one + step / 4, far = one + 3 * step / 4, down = -one - step / 4;
        std::fesetround(rounding);
        const volatile double other_up = one + step / 4, other_far = one + 3 * step / 4, other_down = -one - step / 4;
        std::fesetround(FE_TONEAREST);
        return other_up != up || other_far != far || other_down != down;
    };
    int unseen = 0;
    for (const int rounding : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) unseen += sums_differ(rounding) ? 1 : 0;
    EXPECT_EQ(unseen, 3);
    EXPECT_FALSE(sums_differ(FE_TONEAREST)) << "control";
    test_support::record_control("A48", unseen);
}

TEST_F(FloatEnvironment, DenormalsThatBecomeZeroAreSeenAndKeptAgain) {
    ASSERT_TRUE(kKnowsControl) << "teach this test the control register of this processor";
    int missed = 0;
    flush_to_zero(true, false);
    if (float_fault() != FloatFault::denormal_inputs) ++missed;
    set_float_environment();
    EXPECT_EQ(float_fault(), FloatFault::none);
    flush_to_zero(false, true);
    const FloatFault results = float_fault();
    if (results != FloatFault::tiny_results && results != FloatFault::denormal_inputs) ++missed;
    set_float_environment();
    EXPECT_EQ(float_fault(), FloatFault::none);
    EXPECT_EQ(missed, 0);
    test_support::record_worst("A45", missed);
}

/// Two different numbers whose difference is 0: what a guard against a division by 0 does not see.
TEST_F(FloatEnvironment, FlushedDifferencesAreZeroWhereNobodyLooks) {
    const volatile float a = 1.5f * std::numeric_limits<float>::min(), b = std::numeric_limits<float>::min();
    const volatile float tiny = a - b;
    EXPECT_NE(tiny, 0);
    flush_to_zero(false, true);
    const volatile float difference = a - b;
    flush_to_zero(true, false);
    const volatile float twice = tiny * 2;
    flush_to_zero(false, false);
    const int unseen = (difference == 0 ? 1 : 0) + (twice == 0 ? 1 : 0);
    EXPECT_EQ(unseen, 2);
    test_support::record_control("A45", unseen);
}

TEST_F(FloatEnvironment, LeaveToForgetNaNIsSeen) {
    EXPECT_FALSE(test_support::probes_of_fast_math().knows_nan()) << "control: compiled with -ffast-math";
    test_support::record_worst("A46", float_fault() == FloatFault::none ? 0 : 1);
    test_support::record_control("A46", test_support::probes_of_fast_math().knows_nan() ? 0 : 1);
}

TEST_F(FloatEnvironment, LeaveToFuseIsSeen) {
    if (test_support::has_fused_instructions()) EXPECT_FALSE(test_support::probes_fused().rounds_products());
}

TEST_F(FloatEnvironment, EveryFaultHasItsWords) {
    for (const FloatFault fault :
         {FloatFault::rounding, FloatFault::denormal_inputs, FloatFault::tiny_results, FloatFault::nan, FloatFault::fused}) {
        EXPECT_FALSE(words_of(fault).empty());
        EXPECT_NE(words_of(fault), words_of(FloatFault::none));
    }
}

}  // namespace
}  // namespace tedavis::base::test_float_environment
