#include "render_core/draw/data/runway_marks.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"

namespace tedavis::draw {
namespace {

constexpr double kThreshold_m = 6, kStripeLength_m = 30, kStripe_m = 1.8;
constexpr double kDigitHeight_m = 9, kDigitWidth_m = 3, kStroke_m = 0.8, kBetweenDigits_m = 2, kClear_m = 12;
constexpr double kDash_m = 30, kPeriod_m = 50, kLine_m = 0.9;
constexpr int kFullTurn = 36;

/// Strokes of a character; R has a leg of its own, and 1 is one bar.
enum Stroke : unsigned {
    kTop = 1,
    kRightUp = 2,
    kRightLow = 4,
    kBottom = 8,
    kLeftLow = 16,
    kLeftUp = 32,
    kMiddle = 64,
    kLeg = 128,
    kBar = 256
};
constexpr unsigned kDigits[10] = {
    kTop | kRightUp | kRightLow | kBottom | kLeftLow | kLeftUp,
    kBar,
    kTop | kRightUp | kMiddle | kLeftLow | kBottom,
    kTop | kRightUp | kMiddle | kRightLow | kBottom,
    kLeftUp | kMiddle | kRightUp | kRightLow,
    kTop | kLeftUp | kMiddle | kRightLow | kBottom,
    kTop | kLeftUp | kMiddle | kRightLow | kBottom | kLeftLow,
    kTop | kRightUp | kRightLow,
    kTop | kRightUp | kRightLow | kBottom | kLeftLow | kLeftUp | kMiddle,
    kTop | kRightUp | kRightLow | kBottom | kLeftUp | kMiddle,
};

unsigned strokes_of(char letter) {
    switch (letter) {
        case 'L': return kLeftUp | kLeftLow | kBottom;
        case 'C': return kTop | kLeftUp | kLeftLow | kBottom;
        default: return kTop | kLeftUp | kLeftLow | kRightUp | kMiddle | kLeg;
    }
}

/// The marks of one end, as its pilot sees them: along from the threshold, across to the right.
class EndMarks {
public:
    EndMarks(RunwayMarks& marks, double length_m, double width_m, bool is_last)
        : marks_(marks), length_m_(length_m), width_m_(width_m), is_last_(is_last) {}

    void add_threshold() {
        const int stripes = std::max(static_cast<int>(std::lround(width_m_ * 4 / 15 / 2)), 2);  // on each side
        for (int n = 0; n < stripes; ++n) {
            const double from_m = kStripe_m * (1 + 2 * n);
            if (from_m + kStripe_m > 0.5 * width_m_) break;
            for (const double side : {-1.0, 1.0}) {
                const double a = side * from_m, b = side * (from_m + kStripe_m);
                add(RunwayMarkKind::threshold, kThreshold_m, kThreshold_m + kStripeLength_m, std::min(a, b), std::max(a, b));
            }
        }
    }

    /// Returns where the number ends.
    double add_number(const RunwayNumber& number) {
        const double scale = std::clamp(0.5 * width_m_ / (2 * kDigitWidth_m + kBetweenDigits_m), 1.0, 2.0);
        double from_m = kThreshold_m + kStripeLength_m + kClear_m;
        if (number.side != 0) {
            character(strokes_of(number.side), from_m, 0, scale);
            from_m += (kDigitHeight_m + 6) * scale;
        }
        const double aside_m = 0.5 * (kDigitWidth_m + kBetweenDigits_m) * scale;
        character(kDigits[number.tens_deg / 10], from_m, -aside_m, scale);
        character(kDigits[number.tens_deg % 10], from_m, aside_m, scale);
        return from_m + kDigitHeight_m * scale;
    }

    void add_aiming_point() {
        const double at_m = aiming_point_m(length_m_);
        if (at_m <= 0) return;
        const bool is_long = length_m_ >= 1200, is_short = length_m_ < 800;
        const double length_m = is_long ? 45 : 30;
        const double free_m = std::min(is_long ? 18.0 : (is_short ? 6.0 : 9.0), 0.45 * width_m_);
        const double wide_m = std::min(is_short ? 4.0 : 6.0, 0.5 * (width_m_ - free_m) - 1);
        for (const double side : {-1.0, 1.0}) {
            const double a = side * 0.5 * free_m, b = side * (0.5 * free_m + wide_m);
            add(RunwayMarkKind::aiming_point, at_m, at_m + length_m, std::min(a, b), std::max(a, b));
        }
    }

private:
    void add(RunwayMarkKind kind, double from_m, double to_m, double left_m, double right_m) {
        RunwayMark mark{from_m, to_m, left_m, right_m, kind};
        if (is_last_) mark = {length_m_ - to_m, length_m_ - from_m, -right_m, -left_m, kind};
        if (!marks_.full()) static_cast<void>(marks_.try_push_back(mark));
    }

    void character(unsigned strokes, double from_m, double middle_m, double scale) {
        const double height = kDigitHeight_m * scale, half = 0.5 * kDigitWidth_m * scale, s = kStroke_m * scale;
        const double low = from_m, middle = from_m + 0.5 * height, high = from_m + height;
        const auto bar = [&](unsigned stroke, double from, double to, double left, double right) {
            if ((strokes & stroke) != 0) add(RunwayMarkKind::number, from, to, middle_m + left, middle_m + right);
        };
        bar(kTop, high - s, high, -half, half);
        bar(kRightUp, middle, high, half - s, half);
        bar(kRightLow, low, middle, half - s, half);
        bar(kBottom, low, low + s, -half, half);
        bar(kLeftLow, low, middle, -half, -half + s);
        bar(kLeftUp, middle, high, -half, -half + s);
        bar(kMiddle, middle - 0.5 * s, middle + 0.5 * s, -half, half);
        bar(kLeg, low, middle, half - 2 * s, half - s);
        bar(kBar, low, high, -0.5 * s, 0.5 * s);
    }

    RunwayMarks& marks_;
    double length_m_, width_m_;
    bool is_last_;
};

/// "08L"; 0 where the text is none.
RunwayNumber number_of(std::string_view text) {
    RunwayNumber number{0, 0};
    std::size_t n = 0;
    for (; n < text.size() && n < 2 && text[n] >= '0' && text[n] <= '9'; ++n)
        number.tens_deg = 10 * number.tens_deg + (text[n] - '0');
    if (n < text.size() && (text[n] == 'L' || text[n] == 'C' || text[n] == 'R')) number.side = text[n++];
    if (n != text.size() || number.tens_deg < 1 || number.tens_deg > kFullTurn) return {0, 0};
    return number;
}

int opposite(int tens_deg) { return tens_deg > kFullTurn / 2 ? tens_deg - kFullTurn / 2 : tens_deg + kFullTurn / 2; }

}  // namespace

RunwayNumbers runway_numbers(std::string_view name, double bearing_rad) {
    const double tens = base::degrees(bearing_rad) / 10;
    const int nearest = static_cast<int>(std::lround(tens - kFullTurn * std::floor(tens / kFullTurn)));
    const int ahead = nearest == 0 ? kFullTurn : nearest;
    const std::string_view last = name.substr(name.rfind(' ') == std::string_view::npos ? 0 : name.rfind(' ') + 1);
    const std::size_t between = last.find('/');
    if (between == std::string_view::npos) return {RunwayNumber{ahead, 0}, RunwayNumber{opposite(ahead), 0}};
    const RunwayNumber first = number_of(last.substr(0, between)), second = number_of(last.substr(between + 1));
    if (first.tens_deg == 0 || second.tens_deg == 0) return {RunwayNumber{ahead, 0}, RunwayNumber{opposite(ahead), 0}};
    const bool agrees = std::fabs(std::remainder(first.tens_deg - tens, kFullTurn)) <= kFullTurn / 4.0;
    return agrees ? RunwayNumbers{first, second} : RunwayNumbers{second, first};
}

double aiming_point_m(double length_m) {
    const double at_m = length_m < 800 ? 150 : (length_m < 1200 ? 250 : (length_m < 2400 ? 300 : 400));
    return at_m + 60 < 0.5 * length_m ? at_m : 0;
}

RunwayMarks runway_marks(double length_m, double width_m, const RunwayNumbers& numbers) {
    RunwayMarks marks;
    double end_m = 0;
    for (const bool is_last : {false, true}) {
        EndMarks end(marks, length_m, width_m, is_last);
        end.add_threshold();
        end_m = std::max(end_m, end.add_number(numbers[is_last ? 1 : 0]));
        end.add_aiming_point();
    }
    const double begins_m = end_m + kClear_m, inner_m = length_m - 2 * begins_m;
    const int dashes = static_cast<int>(std::floor((inner_m + kPeriod_m - kDash_m) / kPeriod_m));
    if (dashes < 1) return marks;
    const double gap_m = dashes > 1 ? (inner_m - kDash_m * dashes) / (dashes - 1) : 0;
    for (int n = 0; n < dashes && !marks.full(); ++n) {
        const double from_m = begins_m + n * (kDash_m + gap_m);
        static_cast<void>(
            marks.try_push_back({from_m, from_m + kDash_m, -0.5 * kLine_m, 0.5 * kLine_m, RunwayMarkKind::center_line}));
    }
    return marks;
}

}  // namespace tedavis::draw
