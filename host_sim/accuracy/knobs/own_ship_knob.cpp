#include "host_sim/accuracy/knobs/own_ship_knob.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bus/state/own_ship_filter.hpp"
#include "host_sim/accuracy/knobs/traced_square.hpp"
#include "host_sim/scenario/seeded_random.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

using base::Duration;
using base::Time;

constexpr double kTurnSpeed_mps = 128.6, kFlown_s = 30, kSettled_s = 2;
constexpr double kMessageStep_s = 0.05, kStampJitter_s = 0.005, kMinDelay_s = 0.004, kMaxDelay_s = 0.012;
constexpr double kFrames_per_s = 60;
constexpr double kPositionNoise_m = 1, kVelocityNoise_mps = 0.1;
constexpr std::size_t kTurnFlights = 24, kQuickTurnFlights = 4;

struct FilterLevel {
    const char* name;
    double limit_s, position_noise_m, acceleration_mps2;
};
/// The third one is what configs/buses/canaerospace.toml states.
constexpr FilterLevel kFilterLevels[] = {
    {"hold the last estimate", 0, 1, 8},
    {"trust each position, extrapolate by velocity", 0.25, 0.05, 100},
    {"filter, 8 m/s2", 0.25, 1, 8},
    {"filter, 2 m/s2", 0.25, 1, 2},
};

KnobFacts own_ship_filter_facts() {
    std::vector<KnobLevel> levels;
    for (const FilterLevel& level : kFilterLevels) levels.push_back({level.name, 0});
    return {"own_ship_filter",
            "Filter of the own ship's position",
            "configs/buses/*.toml: extrapolation_limit_s, position_noise_m, acceleration_mps2",
            "horizontal distance from the true place, 60 times a second",
            "m",
            {"the formula of a flight of 250 kt in turns of 1 to 4 degrees/s", 1e-3,
             "the flight is a formula; distances are those of the plane that touches the ellipsoid, below 200 m"},
            "none: the truth is made, not measured; NUMERICS A16 has figures of another program",
            "A position that is stale or lost is stated as such at every level.",
            "no scale: four ways to a position",
            std::nullopt,
            std::move(levels)};
}

enum class OwnShipMessage : std::uint8_t { latitude, longitude, height, speed, track };

struct SentMessage {
    Time stamped, arrives;
    OwnShipMessage kind;
    double value;
};

Time after_start(double seconds) { return Time{1'000'000'000'000} + Duration::from_seconds(seconds); }

/// A turn at constant rate and speed round a place, and what a bus says of it.
class TurnFlight {
public:
    explicit TurnFlight(SeededRandom& numbers)
        : latitude_rad_(numbers.between(-1, 1)),
          longitude_rad_(numbers.between(-3, 3)),
          turn_per_s_(base::radians(numbers.between(1, 4))),
          begin_rad_(numbers.between(0, 6.28)) {
        const double north_m = earth::meridian_radius_m(latitude_rad_);
        const double east_m = earth::prime_vertical_radius_m(latitude_rad_) * std::cos(latitude_rad_);
        radius_latitude_rad_ = kTurnSpeed_mps / turn_per_s_ / north_m;
        radius_longitude_rad_ = kTurnSpeed_mps / turn_per_s_ / east_m;
        for (double at_s = 0; at_s < kFlown_s; at_s += kMessageStep_s) send_all(at_s, numbers);
        std::sort(messages_.begin(), messages_.end(), [](const auto& a, const auto& b) { return a.arrives < b.arrives; });
    }

    [[nodiscard]] const std::vector<SentMessage>& messages() const { return messages_; }
    [[nodiscard]] double latitude_rad(double at_s) const { return latitude_rad_ + radius_latitude_rad_ * std::sin(angle(at_s)); }
    [[nodiscard]] double longitude_rad(double at_s) const {
        return longitude_rad_ - radius_longitude_rad_ * std::cos(angle(at_s));
    }
    [[nodiscard]] double distance_m(const flight::OwnShipEstimate& estimate, double at_s) const {
        return std::hypot(north_m_per_rad(at_s) * (estimate.position.latitude_rad - latitude_rad(at_s)),
                          east_m_per_rad(at_s) * (estimate.position.longitude_rad - longitude_rad(at_s)));
    }

private:
    [[nodiscard]] double angle(double at_s) const { return begin_rad_ + turn_per_s_ * at_s; }
    [[nodiscard]] double north_m_per_rad(double at_s) const { return earth::meridian_radius_m(latitude_rad(at_s)); }
    [[nodiscard]] double east_m_per_rad(double at_s) const {
        return earth::prime_vertical_radius_m(latitude_rad(at_s)) * std::cos(latitude_rad(at_s));
    }
    [[nodiscard]] double north_mps(double at_s) const {
        return north_m_per_rad(at_s) * radius_latitude_rad_ * turn_per_s_ * std::cos(angle(at_s));
    }
    [[nodiscard]] double east_mps(double at_s) const {
        return east_m_per_rad(at_s) * radius_longitude_rad_ * turn_per_s_ * std::sin(angle(at_s));
    }
    /// Twelve even numbers make one that is normally distributed for all that matters here.
    static double noise(SeededRandom& numbers) {
        double sum = -6;
        for (int n = 0; n < 12; ++n) sum += numbers.between(0, 1);
        return sum;
    }
    void send_all(double at_s, SeededRandom& numbers) {
        for (const OwnShipMessage kind : {OwnShipMessage::latitude, OwnShipMessage::longitude, OwnShipMessage::height,
                                          OwnShipMessage::speed, OwnShipMessage::track}) {
            const double sent_s = at_s + numbers.between(0, kStampJitter_s);
            messages_.push_back({after_start(sent_s), after_start(sent_s + numbers.between(kMinDelay_s, kMaxDelay_s)), kind,
                                 measured(kind, sent_s, numbers)});
        }
    }
    [[nodiscard]] double measured(OwnShipMessage kind, double at_s, SeededRandom& numbers) const {
        const double off = noise(numbers);
        switch (kind) {
            case OwnShipMessage::latitude: return latitude_rad(at_s) + off * kPositionNoise_m / north_m_per_rad(at_s);
            case OwnShipMessage::longitude: return longitude_rad(at_s) + off * kPositionNoise_m / east_m_per_rad(at_s);
            case OwnShipMessage::height: return 1000;
            case OwnShipMessage::speed: return std::hypot(north_mps(at_s), east_mps(at_s)) + off * kVelocityNoise_mps;
            case OwnShipMessage::track: break;
        }
        return std::atan2(east_mps(at_s), north_mps(at_s)) + off * kVelocityNoise_mps / kTurnSpeed_mps;
    }

    double latitude_rad_, longitude_rad_, turn_per_s_, begin_rad_;
    double radius_latitude_rad_ = 0, radius_longitude_rad_ = 0;
    std::vector<SentMessage> messages_;  ///< in the order of arrival
};

void tell(bus::OwnShipFilter& filter, const SentMessage& message) {
    switch (message.kind) {
        case OwnShipMessage::latitude: return filter.add_latitude(message.value, message.stamped);
        case OwnShipMessage::longitude: return filter.add_longitude(message.value, message.stamped);
        case OwnShipMessage::height: return filter.add_height(bus::HeightSource::ellipsoid, message.value, message.stamped);
        case OwnShipMessage::speed: return filter.add_ground_speed(message.value, message.stamped);
        case OwnShipMessage::track: return filter.add_true_track(message.value, message.stamped);
    }
}

class OwnShipFilterKnob final : public Knob {
public:
    explicit OwnShipFilterKnob(const KnobGround& ground) : Knob(own_ship_filter_facts()) {
        SeededRandom numbers(17);
        for (std::size_t n = 0; n < (ground.is_quick ? kQuickTurnFlights : kTurnFlights); ++n) flights_.emplace_back(numbers);
    }

    [[nodiscard]] std::size_t samples() const override { return flights_.size(); }
    void run(std::size_t level, std::size_t sample) override {
        fly(level, flights_[sample], [this](const auto& estimate, double) { found_ += estimate.position.latitude_rad; });
    }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        const TurnFlight& flight = flights_[sample];
        fly(level, flight, [&](const auto& estimate, double at_s) { errors.push_back(flight.distance_m(estimate, at_s)); });
    }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        char text[60];
        std::snprintf(text, sizeof text, "flight %zu, %.2f s after its start", sample,
                      kSettled_s + static_cast<double>(error) / kFrames_per_s);
        return text;
    }

private:
    /// Calls `frame` with the estimate of each frame, once the filter has settled.
    template <class Frame>
    static void fly(std::size_t level, const TurnFlight& flight, Frame frame) {
        bus::OwnShipSettings settings;
        settings.extrapolation_limit = Duration::from_seconds(kFilterLevels[level].limit_s);
        settings.position_noise_m = kFilterLevels[level].position_noise_m;
        settings.acceleration_mps2 = kFilterLevels[level].acceleration_mps2;
        bus::OwnShipFilter filter(settings);
        auto next = flight.messages().begin();
        for (int n = 0; n < static_cast<int>(kFlown_s * kFrames_per_s); ++n) {
            const double at_s = n / kFrames_per_s;
            for (; next != flight.messages().end() && next->arrives <= after_start(at_s); ++next) tell(filter, *next);
            if (at_s >= kSettled_s) frame(filter.estimate(after_start(at_s)), at_s);
        }
    }

    std::vector<TurnFlight> flights_;
    double found_ = 0;  ///< so that no compiler leaves the filter out
};

}  // namespace

std::unique_ptr<Knob> make_own_ship_filter_knob(const KnobGround& ground) { return std::make_unique<OwnShipFilterKnob>(ground); }

}  // namespace tedavis::host_sim
