#include "host_sim/flight_log/flight_log_writer.hpp"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "bus/canaerospace/message_encoder.hpp"
#include "bus/canaerospace/traffic_profile.hpp"
#include "bus/candump/candump_log_writer.hpp"
#include "host_sim/calendar_time.hpp"
#include "host_sim/flight_log/message_schedule.hpp"
#include "host_sim/flight_log/stream_sink.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr base::Duration kFrameTime{125'000};  // 125 bits at 1 Mbit/s
constexpr std::int64_t kNanosecondsPerMillisecond = 1'000'000;
constexpr std::int64_t kMillisecondsPerSecond = 1000;
constexpr std::int64_t kAttitudePeriod_ms = 20;
constexpr std::int64_t kProgressEvery_ms = 1000;
constexpr std::int64_t kNewsPeriod_ms = 20, kNewsOffset_ms = 19;  // when changes of what is selected are looked for
/// Within a second: when the first aircraft is reported, and how much later the next one.
constexpr std::int64_t kTrafficOffset_ms = 43, kTrafficApart_ms = 20;
static_assert(kTrafficOffset_ms + bus::kTrafficNumbers * kTrafficApart_ms <= kMillisecondsPerSecond);
static_assert(bus::kTrafficParts <= kTrafficApart_ms);

class LogRun {
public:
    LogRun(const FlightSource& flight, const FlightLogSettings& settings, std::ostream& stream)
        : flight_(flight),
          name_(settings.name),
          node_(settings.node),
          first_traffic_(settings.bus.traffic.first_identifier),
          guidance_(settings.bus.guidance),
          encoder_(settings.bus, settings.node),
          sink_(stream),
          names_{settings.interface_name},
          writer_(sink_, {names_.data(), names_.size()}, bus::StampDigits::micro, false) {}

    FlightLogCounts run(const LogProgress& progress) {
        const std::int64_t first = ceil_ms(flight_.begin()), last = flight_.end().ns / kNanosecondsPerMillisecond;
        for (std::int64_t ms = first; ms <= last; ++ms) {
            write_millisecond(ms);
            if ((ms - first) % kProgressEvery_ms != 0) continue;
            if (!progress(static_cast<double>(ms - first) / static_cast<double>(last - first + 1))) {
                counts_.interrupted = true;
                break;
            }
        }
        counts_.frames = writer_.written();
        return counts_;
    }

private:
    /// Messages of the schedule, for each millisecond of a second.
    using DueMessages = std::array<std::vector<std::uint8_t>, static_cast<std::size_t>(kMillisecondsPerSecond)>;

    static std::int64_t ceil_ms(base::Time time) {
        return (time.ns + kNanosecondsPerMillisecond - 1) / kNanosecondsPerMillisecond;
    }

    void write_millisecond(std::int64_t ms) {
        const base::Time time{ms * kNanosecondsPerMillisecond};
        next_stamp_ = time;
        std::optional<SignalSample> sample;
        bool asked = false;
        for (const std::uint8_t n :
             due_[static_cast<std::size_t>((ms % kMillisecondsPerSecond + kMillisecondsPerSecond) % kMillisecondsPerSecond)]) {
            const ScheduledMessage& message = message_schedule()[n];
            const bool may_be_news = is_selected(message) && ms % kNewsPeriod_ms == kNewsOffset_ms;
            if (!asked) sample = flight_.at(time);
            asked = true;
            if (!sample) break;
            if (may_be_news && !is_news(message.signal, *sample)) continue;
            send_value(message, *sample, time);
        }
        if (sample && ms % kMillisecondsPerSecond == 0) send_clock(time);
        if (asked && !sample && ms % kAttitudePeriod_ms == 0) counts_.silent_ms += kAttitudePeriod_ms;
        send_phase(ms, time);
        send_traffic(ms, time);
    }

    /// Every period divides a second.
    static DueMessages due_messages() {
        DueMessages due;
        const base::Span<const ScheduledMessage> schedule = message_schedule();
        for (std::size_t ms = 0; ms < due.size(); ++ms)
            for (std::size_t n = 0; n < schedule.size(); ++n)
                if (ms % schedule[n].period_ms == schedule[n].offset_ms ||
                    (is_selected(schedule[n]) && ms % kNewsPeriod_ms == kNewsOffset_ms))
                    due[ms].push_back(static_cast<std::uint8_t>(n));
        return due;
    }

    /// What is selected is also sent when it changes.
    static bool is_selected(const ScheduledMessage& message) {
        return message.is_guidance && message.period_ms == kMillisecondsPerSecond;
    }
    [[nodiscard]] bool is_news(flight::Signal signal, const SignalSample& sample) const {
        return sample.has(signal) != last_sent_.has(signal) || (sample.has(signal) && sample[signal] != last_sent_[signal]);
    }

    void send_value(const ScheduledMessage& message, const SignalSample& sample, base::Time time) {
        if (message.is_guidance && !guidance_.is_carried()) return;
        const auto identifier =
            static_cast<std::uint16_t>(message.identifier + (message.is_guidance ? guidance_.first_identifier : 0));
        last_sent_[message.signal] = sample[message.signal];
        has_radio_height_ = has_radio_height_ || sample.has(flight::Signal::radio_height);
        if (message.signal == flight::Signal::magnetic_variation) encoder_.set_variation(sample[message.signal]);
        if (sample.has(message.signal))
            send(encoder_.encode(identifier, sample[message.signal], message.type, time, out()));
        else if (states_nothing(message))
            send(encoder_.encode_nothing_selected(identifier, time, out()));
    }

    /// Nothing is selected, or the ground is out of the radio altimeter's range.
    [[nodiscard]] bool states_nothing(const ScheduledMessage& message) const {
        return message.signal == flight::Signal::radio_height ? has_radio_height_
                                                              : message.is_guidance && flight_.states_guidance();
    }

    void send_clock(base::Time time) {
        const CalendarDate date = calendar_date(time);
        const std::int64_t of_day = date.second_of_day;
        send(encoder_.encode_utc(static_cast<std::uint8_t>(of_day / 3600), static_cast<std::uint8_t>(of_day / 60 % 60),
                                 static_cast<std::uint8_t>(of_day % 60), time, out()));
        send(encoder_.encode_date(static_cast<std::uint8_t>(date.day), static_cast<std::uint8_t>(date.month),
                                  static_cast<std::uint16_t>(date.year), time, out()));
    }

    void send_phase(std::int64_t ms, base::Time time) {
        const auto phase = flight_.stated_phase(time);
        const bool changed = phase.has_value() && (!last_phase_ || *last_phase_ != *phase);
        last_phase_ = phase;
        if (!phase || !(changed || ms % kMillisecondsPerSecond == 0)) return;
        ++counts_.phase_messages;
        send(encoder_.encode_phase(*phase, bus::PhaseOrigin::simulator, bus::kConfidenceNotStated, true, time, out()));
    }

    void send_traffic(std::int64_t ms, base::Time time) {
        if (first_traffic_ == 0) return;
        const std::int64_t of_second = ms % kMillisecondsPerSecond - kTrafficOffset_ms;
        if (of_second >= 0 && of_second % kTrafficApart_ms == 0)
            begin_report(static_cast<std::size_t>(of_second / kTrafficApart_ms), time);
        if (next_part_ == bus::kTrafficParts) return;
        frames_[0] = report_[next_part_++];
        send(1);
    }

    void begin_report(std::size_t number, base::Time time) {
        for (const ReceivedAircraft& received : flight_.traffic(time)) {
            if (received.number != number || number >= codes_.size()) continue;
            const bus::TrafficSender sender{first_traffic_, node_, received.number, codes_[number]};
            const std::size_t count = encode_traffic(received.report, sender, time, {report_.data(), report_.size()});
            if (count == 0) continue;  // outside of what can be said
            ++codes_[number];
            next_part_ = 0;
        }
    }

    base::Span<bus::CanFrame> out() { return {frames_.data(), frames_.size()}; }

    void send(std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            frames_[i].time = next_stamp_;
            next_stamp_ = next_stamp_ + kFrameTime;
            if (!writer_.write(frames_[i])) throw UserError(name_ + ": could not be written to its end; check the free space");
        }
    }

    const FlightSource& flight_;
    std::string name_;
    std::uint8_t node_;
    std::uint16_t first_traffic_;  ///< 0: the bus carries none
    bus::GuidanceSettings guidance_;
    const DueMessages due_ = due_messages();
    bool has_radio_height_ = false;  ///< the aircraft has a radio altimeter
    SignalSample last_sent_;
    bus::MessageEncoder encoder_;
    StreamSink sink_;
    std::array<std::string_view, 1> names_;
    bus::CandumpLogWriter writer_;
    std::array<bus::CanFrame, 2> frames_;
    std::array<bus::CanFrame, bus::kTrafficParts> report_;
    std::size_t next_part_ = bus::kTrafficParts;  ///< of the report, to be sent
    std::array<std::uint8_t, bus::kTrafficNumbers> codes_{};
    base::Time next_stamp_;
    std::optional<flight::FlightPhase> last_phase_;
    FlightLogCounts counts_;
};

}  // namespace

FlightLogCounts write_flight_log(const FlightSource& flight, const FlightLogSettings& settings, std::ostream& stream,
                                 const LogProgress& progress) {
    return LogRun(flight, settings, stream).run(progress);
}

}  // namespace tedavis::host_sim
