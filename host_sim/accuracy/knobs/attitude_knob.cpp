#include "host_sim/accuracy/knobs/attitude_knob.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/matrix.hpp>
#include <iterator>

#include "host_sim/importers/monotone_curve.hpp"
#include "host_sim/scenario/seeded_random.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kTurnsOfSample = 64, kTurnSamples = 32, kQuickTurnSamples = 8;
constexpr int kSharesOfTurn = 8;
constexpr double kMaxPitchOfTurn_deg = 20, kMaxRollOfTurn_deg = 45, kMaxTurn_deg = 30;

constexpr std::size_t kAnglesLevel = 0, kStraightLevel = 1, kSlerpLevel = 2;
constexpr const char* kAttitudeLevelNames[] = {"heading, pitch and roll each for itself", "quaternions on a straight line",
                                               "quaternions on the sphere"};

/// A unit quaternion: the body's axes in north, east and down.
template <class Real>
struct Quaternion {
    Real w, x, y, z;

    static Quaternion of(const Attitude& attitude) {
        const Real h = static_cast<Real>(attitude.heading_rad) / 2, p = static_cast<Real>(attitude.pitch_rad) / 2,
                   r = static_cast<Real>(attitude.roll_rad) / 2;
        const Real ch = std::cos(h), sh = std::sin(h), cp = std::cos(p), sp = std::sin(p), cr = std::cos(r), sr = std::sin(r);
        return {ch * cp * cr + sh * sp * sr, ch * cp * sr - sh * sp * cr, ch * sp * cr + sh * cp * sr,
                sh * cp * cr - ch * sp * sr};
    }
    [[nodiscard]] Quaternion mixed(Real mine, const Quaternion& other, Real others) const {
        return {mine * w + others * other.w, mine * x + others * other.x, mine * y + others * other.y,
                mine * z + others * other.z};
    }
    [[nodiscard]] Real length() const { return std::sqrt(w * w + x * x + y * y + z * z); }
    [[nodiscard]] glm::dmat3 axes() const {
        const auto column = [](Real a, Real b, Real c) {
            return glm::dvec3(static_cast<double>(a), static_cast<double>(b), static_cast<double>(c));
        };
        return {column(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)),
                column(2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)),
                column(2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y))};
    }
};

/// Of a quaternion and its negative, which are the same attitude, the one on `from`'s side.
template <class Real>
Quaternion<Real> nearer_to(const Quaternion<Real>& from, const Quaternion<Real>& to) {
    const Real dot = from.w * to.w + from.x * to.x + from.y * to.y + from.z * to.z;
    return dot < 0 ? Quaternion<Real>{-to.w, -to.x, -to.y, -to.z} : to;
}

template <class Real>
Quaternion<Real> straight_between(const Quaternion<Real>& from, const Quaternion<Real>& to, Real share) {
    const Quaternion<Real> on_chord = from.mixed(1 - share, nearer_to(from, to), share);
    const Real length = on_chord.length();
    return {on_chord.w / length, on_chord.x / length, on_chord.y / length, on_chord.z / length};
}

template <class Real>
Quaternion<Real> slerp_between(const Quaternion<Real>& from, const Quaternion<Real>& other, Real share) {
    const Quaternion<Real> to = nearer_to(from, other);
    const Real angle = 2 * std::atan2(from.mixed(1, to, -1).length(), from.mixed(1, to, 1).length());
    if (!(angle > 0)) return from;
    return from.mixed(std::sin((1 - share) * angle) / std::sin(angle), to, std::sin(share * angle) / std::sin(angle));
}

/// From the differences of the axes, which loses no digits where these are almost the same.
double degrees_apart(const glm::dmat3& a, const glm::dmat3& b) {
    double square = 0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) square += (a[c][r] - b[c][r]) * (a[c][r] - b[c][r]);
    return base::degrees(2 * std::asin(std::min(std::sqrt(square / 8), 1.0)));
}

/// Two attitudes of a flight, and what each level has prepared of them.
class FlownTurn {
public:
    explicit FlownTurn(SeededRandom& numbers) {
        from_ = {numbers.within(0, base::kPi), angle(numbers, kMaxPitchOfTurn_deg), angle(numbers, kMaxRollOfTurn_deg)};
        to_ = {from_.heading_rad + angle(numbers, kMaxTurn_deg), from_.pitch_rad + angle(numbers, kMaxTurn_deg),
               from_.roll_rad + angle(numbers, kMaxTurn_deg)};
        heading_ = MonotoneCurve({0, 1}, {from_.heading_rad, to_.heading_rad});
        pitch_ = MonotoneCurve({0, 1}, {from_.pitch_rad, to_.pitch_rad});
        roll_ = MonotoneCurve({0, 1}, {from_.roll_rad, to_.roll_rad});
        quaternions_[0] = Quaternion<double>::of(from_);
        quaternions_[1] = Quaternion<double>::of(to_);
    }

    [[nodiscard]] glm::dmat3 axes(std::size_t level, double share) const {
        if (level == kStraightLevel) return straight_between(quaternions_[0], quaternions_[1], share).axes();
        if (level == kSlerpLevel) return slerp_between(quaternions_[0], quaternions_[1], share).axes();
        return earth::body_axes(0, 0, heading_.at(share), pitch_.at(share), roll_.at(share));
    }
    [[nodiscard]] double degrees_off(std::size_t level, double share) const {
        const glm::dmat3 frame = level == kAnglesLevel ? earth::north_east_down(0, 0) : glm::dmat3(1.0);
        return degrees_apart(axes(level, share), frame * axes_by_long_slerp(from_, to_, share));
    }
    [[nodiscard]] std::string text(double share) const {
        char text[160];
        std::snprintf(text, sizeof text, "%.3f of the way from heading %.1f, pitch %.1f, roll %.1f to %.1f, %.1f, %.1f degrees",
                      share, base::degrees(from_.heading_rad), base::degrees(from_.pitch_rad), base::degrees(from_.roll_rad),
                      base::degrees(to_.heading_rad), base::degrees(to_.pitch_rad), base::degrees(to_.roll_rad));
        return text;
    }

private:
    static double angle(SeededRandom& numbers, double most_deg) { return base::radians(numbers.within(0, most_deg)); }

    Attitude from_, to_;
    MonotoneCurve heading_, pitch_, roll_;
    Quaternion<double> quaternions_[2]{};
};

KnobFacts attitude_between_facts() {
    std::vector<KnobLevel> levels;
    for (const char* const name : kAttitudeLevelNames) levels.push_back({name, 0});
    return {
        "attitude_between",
        "Attitude between two that are given",
        "curves of `replay --window --tour`; a flight's display holds the attitude of the last message",
        "angle from the shortest turn at a constant rate, between attitudes up to 30 degrees apart in each of heading, pitch "
        "and roll",
        "degrees",
        {"quaternions on the sphere in long double", 1e-13, "a turn has 18 digits; axes are compared as doubles"},
        "the turn about the axis of both attitudes, by its matrix (tests/host_sim/accuracy)",
        "Attitudes of a flight are shown as the bus states them.",
        "no scale: three ways",
        std::nullopt,
        std::move(levels),
        "a tour has its given attitudes exactly and banks as a pilot states it; its way between them is a matter of taste, not "
        "of truth"};
}

class AttitudeBetweenKnob final : public Knob {
public:
    explicit AttitudeBetweenKnob(const KnobGround& ground) : Knob(attitude_between_facts()) {
        SeededRandom numbers(23);
        const std::size_t count = kTurnsOfSample * (ground.is_quick ? kQuickTurnSamples : kTurnSamples);
        for (std::size_t n = 0; n < count; ++n) turns_.emplace_back(numbers);
    }

    [[nodiscard]] std::size_t samples() const override { return turns_.size() / kTurnsOfSample; }
    void run(std::size_t level, std::size_t sample) override {
        for (std::size_t n = 0; n < kTurnsOfSample; ++n)
            for (int k = 0; k < kSharesOfTurn; ++k) {
                const glm::dmat3 axes = turns_[sample * kTurnsOfSample + n].axes(level, share(k));
                seen_ += axes[0] + axes[1] + axes[2];
            }
    }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        for (std::size_t n = 0; n < kTurnsOfSample; ++n)
            for (int k = 0; k < kSharesOfTurn; ++k)
                errors.push_back(turns_[sample * kTurnsOfSample + n].degrees_off(level, share(k)));
    }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        const std::size_t turn = error / kSharesOfTurn;
        return turns_[sample * kTurnsOfSample + turn].text(share(static_cast<int>(error % kSharesOfTurn)));
    }

private:
    static double share(int number) { return (number + 0.5) / kSharesOfTurn; }

    std::vector<FlownTurn> turns_;
    glm::dvec3 seen_{0};  ///< so that no compiler leaves the attitudes out
};

}  // namespace

glm::dmat3 axes_by_long_slerp(const Attitude& from, const Attitude& to, double share) {
    using LongQuaternion = Quaternion<long double>;
    return slerp_between(LongQuaternion::of(from), LongQuaternion::of(to), static_cast<long double>(share)).axes();
}

std::unique_ptr<Knob> make_attitude_between_knob(const KnobGround& ground) {
    return std::make_unique<AttitudeBetweenKnob>(ground);
}

}  // namespace tedavis::host_sim
