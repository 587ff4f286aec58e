#include "host_sim/flight_test/step_log.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "bus/candump/candump_log_writer.hpp"
#include "bus/switches/switch_log.hpp"
#include "host_sim/calendar_time.hpp"
#include "host_sim/flight_log/stream_sink.hpp"
#include "host_sim/flight_test/sent_message.hpp"
#include "host_sim/flight_test/stepped_aircraft.hpp"
#include "host_sim/flight_test/timed_input.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::int64_t kStepMillisecond_ns = 1'000'000, kStepSecond_ms = 1000;
constexpr std::uint32_t kMeansNothing = 2031;  // a node service, which no bus file gives a meaning

class StepLog {
public:
    StepLog(const FlightTest& test, std::ostream& stream, const std::string& name)
        : test_(test),
          name_(name),
          aircraft_(test.start),
          encoder_(test.bus, kMadeFrameNode),
          sink_(stream),
          writer_(sink_, {names_.data(), names_.size()}, bus::StampDigits::micro, false) {
        for (std::size_t n = 0; n < flight::kSignalCount; ++n)
            if (const auto message = sent_message(static_cast<flight::Signal>(n), test.bus)) messages_.push_back(*message);
    }

    void write() {
        const auto last = static_cast<std::int64_t>(std::llround(test_.end_s * kStepSecond_ms));
        for (std::int64_t ms = 0; ms <= last; ++ms) {
            begin_millisecond(ms);
            take_steps(ms);
            for (const ScheduledMessage& message : messages_)
                if (ms % message.period_ms == message.offset_ms) send_signal(message, ms);
            if (ms % kStepSecond_ms == 0) send_clock();
            send_phase(ms);
            if ((ms == 0 || ms == last) && !has_frame_) send_nothing();  // expectations count from the log's first frame
        }
    }

private:
    enum class Sending : std::uint8_t { normal, stopped, invalid };

    void begin_millisecond(std::int64_t ms) {
        stamp_ = now_ = test_.start.time + base::Duration{ms * kStepMillisecond_ns};
        has_frame_ = false;
    }

    void take_steps(std::int64_t ms) {
        const double time_s = static_cast<double>(ms) / kStepSecond_ms;
        while (next_step_ < test_.steps.size() && std::llround(test_.steps[next_step_].at_s * kStepSecond_ms) <= ms) {
            step_ = &test_.steps[next_step_++];
            aircraft_.advance_to(time_s);
            aircraft_.take(*step_, time_s);
            set_sending(*step_);
            for (bus::CanFrame frame : step_->frames) send(frame);
        }
    }

    void set_sending(const TestStep& step) {
        const auto set = [this](const std::vector<flight::Signal>& signals, Sending sending) {
            for (const flight::Signal signal : signals) sending_[static_cast<std::size_t>(signal)] = sending;
        };
        for (const auto* const targets : {&step.hold, &step.ramp})
            for (const SignalTarget& target : *targets) sending_[static_cast<std::size_t>(target.signal)] = Sending::normal;
        set(step.stop, Sending::stopped);
        set(step.send, Sending::normal);
        set(step.invalid, Sending::invalid);
        if (step.stops_clock) sends_clock_ = false;
        if (step.sends_clock) sends_clock_ = true;
        if (step.stops_phase) phase_ = nullptr;
        if (step.phase) {
            phase_ = &step;
            phase_is_news_ = true;
        }
    }

    void send_signal(const ScheduledMessage& message, std::int64_t ms) {
        const Sending sending = sending_[static_cast<std::size_t>(message.signal)];
        if (sending == Sending::stopped) return;
        aircraft_.advance_to(static_cast<double>(ms) / kStepSecond_ms);
        const SignalSample sample = aircraft_.sample();
        if (!sample.has(message.signal)) return send_no_height(message);
        if (message.signal == flight::Signal::magnetic_variation) encoder_.set_variation(sample[message.signal]);
        const std::size_t count = encoder_.encode(message.identifier, sample[message.signal], message.type, now_, out(), 0,
                                                  sending == Sending::invalid ? 1 : 0);
        if (count == 0) refuse(message.signal);
        send_encoded(count);
    }

    /// A radio altimeter out of its range says so.
    void send_no_height(const ScheduledMessage& message) {
        if (message.signal == flight::Signal::radio_height && test_.start.ground_msl_m)
            send_encoded(encoder_.encode_nothing_selected(message.identifier, now_, out()));
    }

    [[noreturn]] void refuse(flight::Signal signal) const {
        const std::string place = step_ != nullptr ? step_->file + ":" + std::to_string(step_->line) : test_.path;
        throw UserError(place + ": the value of '" + flight::to_string(signal) +
                        "' cannot be sent on this bus; say another one, or another bus file");
    }

    void send_clock() {
        if (!sends_clock_) return;
        const CalendarDate date = calendar_date(now_);
        const int second = date.second_of_day;
        send_encoded(encoder_.encode_utc(static_cast<std::uint8_t>(second / 3600), static_cast<std::uint8_t>(second / 60 % 60),
                                         static_cast<std::uint8_t>(second % 60), now_, out()));
        send_encoded(encoder_.encode_date(static_cast<std::uint8_t>(date.day), static_cast<std::uint8_t>(date.month),
                                          static_cast<std::uint16_t>(date.year), now_, out()));
    }

    void send_phase(std::int64_t ms) {
        if (phase_ == nullptr || !(phase_is_news_ || ms % kStepSecond_ms == 0)) return;
        phase_is_news_ = false;
        send_encoded(encoder_.encode_phase(*phase_->phase, phase_->phase_origin, bus::kConfidenceNotStated, phase_->phase_valid,
                                           now_, out()));
    }

    void send_nothing() {
        bus::CanFrame frame;
        frame.id = kMeansNothing;
        send(frame);
    }

    base::Span<bus::CanFrame> out() { return {encoded_.data(), encoded_.size()}; }
    void send_encoded(std::size_t count) {
        for (std::size_t n = 0; n < count; ++n) send(encoded_[n]);
    }
    void send(bus::CanFrame& frame) {
        frame.time = stamp_;
        stamp_ = stamp_ + kMadeFrameTime;
        has_frame_ = true;
        if (!writer_.write(frame)) throw UserError(name_ + ": could not be written to its end; check the free space");
    }

    const FlightTest& test_;
    std::string name_;
    SteppedAircraft aircraft_;
    bus::MessageEncoder encoder_;
    StreamSink sink_;
    std::array<std::string_view, 1> names_{"can0"};
    bus::CandumpLogWriter writer_;
    std::vector<ScheduledMessage> messages_;
    std::array<Sending, flight::kSignalCount> sending_{};
    std::array<bus::CanFrame, 2> encoded_;
    std::size_t next_step_ = 0;
    const TestStep* step_ = nullptr;   ///< the latest one
    const TestStep* phase_ = nullptr;  ///< whose phase is stated; null: none is
    bool phase_is_news_ = false, sends_clock_ = true, has_frame_ = false;
    base::Time now_, stamp_;
};

struct PanelChange {
    base::Time time;
    std::size_t line = 0;
    bool level = false;
};

/// The first edges are the levels at start, with those of steps at 0 s.
class PanelEdges {
public:
    explicit PanelEdges(const FlightTest& test) : test_(test), levels_(resting_levels(test.panel)) {
        for (std::size_t line = 0; line < test.panel.lines.size(); ++line) initial_.push_back((levels_ >> line & 1u) != 0);
    }

    std::vector<PanelChange> changes() {
        std::vector<PanelChange> first, later;
        for (const TestStep& step : test_.steps) add(step, later);
        for (std::size_t line = 0; line < initial_.size(); ++line) first.push_back({test_.start.time, line, initial_[line]});
        first.insert(first.end(), later.begin(), later.end());
        std::stable_sort(first.begin(), first.end(), [](const PanelChange& a, const PanelChange& b) { return a.time < b.time; });
        return first;
    }

private:
    void add(const TestStep& step, std::vector<PanelChange>& later) {
        for (const LineLevel& line : step.lines) {
            set(line.line, line.level);
            if (step.at_s <= 0)
                initial_[line.line] = line.level;
            else
                later.push_back({at(step.at_s), line.line, line.level});
        }
        if (!step.bounce) return;
        for (std::uint32_t n = 0; n < step.bounce->times; ++n) {
            set(step.bounce->line, (levels_ >> step.bounce->line & 1u) == 0);
            later.push_back(
                {at(step.at_s + n * step.bounce->gap_s), step.bounce->line, (levels_ >> step.bounce->line & 1u) != 0});
        }
    }

    void set(std::size_t line, bool level) {
        const std::uint32_t bit = std::uint32_t{1} << line;
        levels_ = level ? levels_ | bit : levels_ & ~bit;
    }
    [[nodiscard]] base::Time at(double seconds) const { return test_.start.time + base::Duration::from_seconds(seconds); }

    const FlightTest& test_;
    std::uint32_t levels_;
    std::vector<bool> initial_;
};

}  // namespace

void write_step_log(const FlightTest& test, std::ostream& stream, const std::string& name) {
    StepLog(test, stream, name).write();
}

std::string step_switch_log(const FlightTest& test) {
    const bool has_any = std::any_of(test.steps.begin(), test.steps.end(),
                                     [](const TestStep& step) { return !step.lines.empty() || step.bounce; });
    if (!has_any) return {};
    std::string text(bus::kSwitchLogHeader);
    for (const PanelChange& change : PanelEdges(test).changes()) {
        std::array<char, bus::kMaxSwitchLogLine> line;
        const bus::SwitchEdge edge{change.time, static_cast<std::uint8_t>(change.line), change.level};
        text.append(line.data(), bus::format_switch_log_line(edge, test.panel, {line.data(), line.size()}));
    }
    return text;
}

}  // namespace tedavis::host_sim
