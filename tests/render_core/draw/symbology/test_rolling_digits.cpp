#include "render_core/draw/symbology/rolling_digits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "tests/support/draw/batch_shapes.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_rolling_digits {
namespace {

using test_support::BatchShape;
using test_support::BatchStore;
using test_support::shapes_of;
using test_support::text_of;

constexpr RollingFormat kSpeed{1, 1};
constexpr RollingFormat kAltitude{20, 2};

const Layout& layout() {
    static const Layout made = make_layout(640, 480, 96);
    return made;
}

std::string reading(const RollingDigits& digits, bool upper) {
    std::string text;
    for (const RollingColumn& column : digits.columns) text += (upper ? column.upper : column.lower).view();
    return text;
}
/// As a person reads the drums.
double read(const RollingDigits& digits) {
    const double lower = std::stod(reading(digits, false)), upper = std::stod(reading(digits, true));
    return lower + digits.share * (upper - lower);
}
/// What printf writes, with the zeros of the last column.
std::string printed(long reading, const RollingFormat& format) {
    char text[24];
    std::snprintf(text, sizeof text, "%s%0*ld", reading < 0 ? "-" : "", format.last_digits, std::labs(reading));
    return text;
}

TEST(RollingDigits, BothReadingsAndTheShareGiveTheValue) {
    for (const RollingFormat& format : {kSpeed, kAltitude})
        for (double value = -2400; value <= 12'000; value += 1.37) {
            const RollingDigits digits = rolling_digits(value, format);
            const long lower = static_cast<long>(std::floor(value / format.step)) * format.step;
            ASSERT_EQ(reading(digits, false), printed(lower, format)) << value;
            ASSERT_EQ(reading(digits, true), printed(lower + format.step, format)) << value;
            ASSERT_NEAR(read(digits), value, 1e-9 * std::fabs(value) + 1e-9);
            ASSERT_GE(digits.share, 0);
            ASSERT_LT(digits.share, 1);
        }
    RollingDigits wrong = rolling_digits(128.5, kSpeed);
    wrong.columns.back().upper = "0";
    EXPECT_GT(std::fabs(read(wrong) - 128.5), 1) << "control: another digit is another value";
}

TEST(RollingDigits, ReadingsGrowWithTheValueWithoutAJump) {
    for (const RollingFormat& format : {kSpeed, kAltitude}) {
        double last = read(rolling_digits(-300, format));
        for (double value = -300 + 0.01; value <= 300; value += 0.01) {
            const double now = read(rolling_digits(value, format));
            ASSERT_GE(now, last) << value;
            ASSERT_LT(now - last, 0.0101) << value;
            last = now;
        }
    }
}

TEST(RollingDigits, ADigitRollsOnlyWhileThoseRightOfItPassToZero) {
    for (const RollingFormat& format : {kSpeed, kAltitude})
        for (double value = 0; value <= 12'000; value += 0.73) {
            const RollingDigits digits = rolling_digits(value, format);
            const std::string last = format.last_digits == 1 ? "9" : "80";
            bool passes = true;  // so far from the right
            for (std::size_t i = digits.columns.size(); i-- > 0;) {
                ASSERT_EQ(digits.columns[i].rolls(), passes) << value << " column " << i;
                const std::string_view lower = digits.columns[i].lower.view();
                passes = passes && lower == (i + 1 == digits.columns.size() ? last : "9");
            }
        }
}

TEST(RollingDigits, KnownReadings) {
    const auto column = [](const RollingDigits& digits, std::size_t i) {
        return std::string(digits.columns[i].lower.view()) + ">" + std::string(digits.columns[i].upper.view());
    };
    const RollingDigits speed = rolling_digits(99.25, kSpeed);
    ASSERT_EQ(speed.columns.size(), 3u);
    EXPECT_EQ(column(speed, 0), ">1");
    EXPECT_EQ(column(speed, 1), "9>0");
    EXPECT_EQ(column(speed, 2), "9>0");
    EXPECT_DOUBLE_EQ(speed.share, 0.25);
    const RollingDigits altitude = rolling_digits(4590, kAltitude);
    ASSERT_EQ(altitude.columns.size(), 3u);
    EXPECT_EQ(column(altitude, 0), "4>4");
    EXPECT_EQ(column(altitude, 1), "5>6");
    EXPECT_EQ(column(altitude, 2), "80>00");
    const RollingDigits below_sea = rolling_digits(-95, kAltitude);
    ASSERT_EQ(below_sea.columns.size(), 3u);
    EXPECT_EQ(column(below_sea, 0), "->");
    EXPECT_EQ(column(below_sea, 1), "1>-");
    EXPECT_EQ(column(below_sea, 2), "00>80");
    EXPECT_DOUBLE_EQ(below_sea.share, 0.25);
}

TEST(RollingDigits, HostileValuesGiveAReading) {
    const double infinite = std::numeric_limits<double>::infinity();
    for (const RollingFormat& format : {kSpeed, kAltitude})
        for (const double value : {std::nan(""), 1e300, -1e300, infinite, -infinite, kMaxRollingValue, -kMaxRollingValue, -0.0}) {
            const RollingDigits digits = rolling_digits(value, format);
            EXPECT_GE(digits.columns.size(), 1u);
            EXPECT_LE(std::fabs(read(digits)), kMaxRollingValue + 1e-6);
        }
}

TEST(RollingDigits, DrawnDigitsStayInTheWindowAndTheNearestReadingIsWrittenFirst) {
    const Rect window{100, 100, 80, 28};
    for (const RollingFormat& format : {kSpeed, kAltitude})
        for (double value = -250; value < 1300; value += 1.7) {
            BatchStore store;
            const RollingDigits digits = rolling_digits(value, format);
            build_rolling_digits(Painter(store.batch, layout()), window, digits, 1.25f,
                                 test_support::day_color(SymbolRole::scale));
            for (const QuadVertex& vertex : store.batch.vertices())
                ASSERT_TRUE(window.shrunk(-0.01f).contains(Point{vertex.x, vertex.y})) << value;
            const std::string text = text_of(store.batch), near = reading(digits, digits.share >= 0.5);
            ASSERT_EQ(text.substr(0, near.size()), near) << value;
        }
    BatchStore control;
    Painter(control.batch, layout()).text("88", {140, 104}, TextAnchor::center, 1.25f);
    EXPECT_FALSE(std::all_of(control.batch.vertices().begin(), control.batch.vertices().end(), [&](const QuadVertex& v) {
        return window.contains(Point{v.x, v.y});
    })) << "control: without the window's clip digits reach out of it";
}

TEST(RollingDigits, AGrowingValueMovesTheDrumDown) {
    const Rect window{100, 100, 80, 28};
    const auto height_of = [&](double value, char letter) {
        BatchStore store;
        build_rolling_digits(Painter(store.batch, layout()), window, rolling_digits(value, kSpeed), 1.25f,
                             test_support::day_color(SymbolRole::scale));
        float y = -1;
        for (const BatchShape& shape : shapes_of(store.batch))
            if (shape.letter == letter) y = shape.bounds.center().y;
        return y;
    };
    EXPECT_NEAR(height_of(123, '3'), window.center().y, 1);
    EXPECT_GT(height_of(123.3, '3'), height_of(123.1, '3'));
    EXPECT_LT(height_of(123.3, '4'), window.center().y);
    EXPECT_EQ(height_of(123.01, '4'), -1) << "at rest only one digit is seen";
    EXPECT_FLOAT_EQ(height_of(123.3, '2'), height_of(123, '2')) << "the tens stand still";
    EXPECT_GT(height_of(129.3, '2'), height_of(129, '2')) << "control: here they roll along";
}

}  // namespace
}  // namespace tedavis::draw::test_rolling_digits
