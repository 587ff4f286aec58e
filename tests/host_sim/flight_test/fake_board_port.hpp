/// A running display without a machine: frames and edges go into the tracker that a board has, in a time that the reader turns,
/// and each frame is a record as a board hands it out.
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bus/tracker/flight_tracker.hpp"
#include "host_sim/flight_test/board_port.hpp"

namespace tedavis::test_support {

class FakeBoardPort final : public host_sim::BoardPort, flight::TerrainHeights {
public:
    /// With a panel all of its lines are low at first.
    FakeBoardPort(const bus::BusSettings& settings, const bus::SwitchConfig* panel, double rate_hz)
        : has_panel_(panel != nullptr),
          period_(base::Duration::from_seconds(1 / rate_hz)),
          next_frame_(now_),
          memory_(std::make_unique<bus::TrackerMemory>(settings, panel, now_)),
          tracker_(std::make_unique<bus::FlightTracker>(*memory_, bus::TrackerPorts{can_, has_panel_ ? &panel_ : nullptr})) {
        for (std::size_t n = 0; has_panel_ && n < panel->lines.size(); ++n)
            panel_.waiting.push_back({now_, static_cast<std::uint8_t>(n), false});
    }

    // What a test turns.
    std::uint64_t closes_after = std::numeric_limits<std::uint64_t>::max();  ///< records
    std::uint64_t drops_record = std::numeric_limits<std::uint64_t>::max();  ///< this one
    std::uint64_t dark_after = std::numeric_limits<std::uint64_t>::max();    ///< its screen is unplugged
    std::uint64_t silent_after = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t dropped = 0;                                    ///< frames of the bus
    base::Duration bus_lasts = base::Duration::seconds(100'000);  ///< `other` is sent for so long
    base::Duration send_takes;                                    ///< of this machine
    std::string leaves_out;                                       ///< a key of the records
    std::vector<std::string> says;                                ///< packets in place of records
    base::Duration bus_delay;                                     ///< from send() to the receiver
    base::Duration pause;                                         ///< of this machine, once, after so much input:
    base::Duration pause_after = base::Duration::seconds(10);
    std::optional<bus::CanFrame> other;  ///< sent by another node with each frame of the display

    [[nodiscard]] const std::vector<bus::CanFrame>& sent() const { return sent_; }
    [[nodiscard]] std::uint64_t frames() const { return frame_; }
    [[nodiscard]] const std::vector<bus::SwitchEdge>& edges() const { return panel_.waiting; }

    [[nodiscard]] base::Time now() override { return now_; }
    [[nodiscard]] std::optional<std::string> next_record(base::Time until) override {
        if (pause.ns > 0 && !sent_.empty() && now_ - sent_.front().time > pause_after) {
            now_ = now_ + pause;
            pause = {};
        }
        if (!waiting_.empty()) {
            std::string record = waiting_.front();
            waiting_.erase(waiting_.begin());
            return record;
        }
        while (next_frame_ <= until) {
            now_ = std::max(now_, next_frame_);
            const base::Time time = next_frame_;
            next_frame_ = next_frame_ + period_;
            if (frame_ >= closes_after) throw host_sim::BoardLost("the display is gone");
            const std::string record = record_at(time);
            if (frame_ - 1 != drops_record && frame_ <= silent_after) return record;
        }
        now_ = std::max(now_, until);
        return std::nullopt;
    }
    /// Draws frames that nobody reads yet; the socket holds some of them, and drops the others.
    void pile_up(std::size_t drawn, std::size_t held) {
        for (std::size_t n = 0; n < drawn; ++n) {
            now_ = std::max(now_, next_frame_);
            std::string record = record_at(next_frame_);
            next_frame_ = next_frame_ + period_;
            if (n < held) waiting_.push_back(std::move(record));
        }
        now_ = now_ + base::Duration::milliseconds(1);
    }
    void send(const bus::CanFrame& frame) override {
        sent_.push_back(frame);
        sent_.back().time = now_;
        can_.waiting.push_back(frame);
        can_.waiting.back().time = now_ + bus_delay;
        has_new_ = true;
        now_ = now_ + send_takes;
        order_.push_back('f');
    }
    [[nodiscard]] std::vector<bus::CanFrame> take_received() override { return std::exchange(received_, {}); }
    [[nodiscard]] std::uint64_t dropped_frames() const override { return dropped; }
    [[nodiscard]] bool has_panel() const override { return has_panel_; }
    void set_line(std::size_t line, bool level) override {
        panel_.waiting.push_back({now_, static_cast<std::uint8_t>(line), level});
        order_.push_back('e');
    }
    /// A letter for each frame and edge, as they came.
    [[nodiscard]] const std::string& order() const { return order_; }

private:
    [[nodiscard]] std::string record_at(base::Time time) {
        if (other && time - base::Time{1'000'000'000'000} <= bus_lasts) {
            can_.waiting.push_back(*other);
            can_.waiting.back().time = time;
            received_.push_back(can_.waiting.back());
        }
        const flight::FrameInput input = tracker_->advance_to(time, *this);
        nlohmann::json json = {{"frame", frame_++}, {"monotonic_s", (time - base::Time{}).to_seconds()}};
        json["on_screen"] = frame_ - 1 <= dark_after;
        json["can_to_screen_ms"] = has_new_ ? nlohmann::json(25.0) : nlohmann::json();
        has_new_ = false;
        json["phase"] = flight::scenario_name(input.phase.phase);
        json["sub_phase"] = flight::sub_phase_name(input.phase.phase);
        json["phase_source"] = flight::to_string(input.phase.source);
        json["switch_fault"] = input.phase.switch_fault;
        json["disagreement"] = input.phase.disagreement;
        json["signals"] = json["values"] = nlohmann::json::object();
        for (std::size_t n = 0; n < flight::kSignalCount; ++n) {
            const auto signal = static_cast<flight::Signal>(n);
            json["signals"][flight::to_string(signal)] = base::to_string(input.state.state_of(signal, time));
            if (input.state[signal].received()) json["values"][flight::to_string(signal)] = input.state[signal].value_or(0);
        }
        json["flags"] = nlohmann::json::array();
        if (input.phase.switch_fault) json["flags"].push_back("phase.switch_fault");
        json["alerts"]["terrain"] = {
            {"level", "none"}, {"watching", false}, {"clearance_m", 0}, {"height_above_terrain_m", nullptr}};
        json["alerts"]["obstacles"] = {{"level", "none"}, {"count", 0}};
        json["effects"] = nlohmann::json::array({{{"name", "haze"}, {"state", "skipped"}, {"reason", "why"}}});
        json["presentation"] = {{"design", "default"}};
        json.erase(leaves_out);
        if (frame_ <= says.size()) return says[frame_ - 1];
        return json.dump();
    }

    /// Gives out what waits when its time has come.
    template <class Port, class Item, class Statistics>
    struct Queue final : Port {
        std::vector<Item> waiting;
        std::size_t next = 0;
        Statistics counts;
        [[nodiscard]] std::size_t read(base::Time until, base::Span<Item> out) override {
            std::size_t count = 0;
            while (count < out.size() && next < waiting.size() && waiting[next].time <= until) out[count++] = waiting[next++];
            return count;
        }
        [[nodiscard]] bus::SourceHealth health() const override { return bus::SourceHealth::running; }
        [[nodiscard]] const Statistics& statistics() const override { return counts; }
    };

    [[nodiscard]] base::Stamped<double> height_above_terrain(const flight::OwnShipEstimate&, base::Time) override { return {}; }

    bool has_panel_;
    base::Time now_{1'000'000'000'000};
    base::Duration period_;
    base::Time next_frame_;
    std::uint64_t frame_ = 0;
    bool has_new_ = false;
    std::string order_;
    std::vector<std::string> waiting_;
    std::vector<bus::CanFrame> sent_, received_;
    Queue<bus::CanSource, bus::CanFrame, bus::SourceStatistics> can_;
    Queue<bus::SwitchSource, bus::SwitchEdge, bus::SwitchStatistics> panel_;
    std::unique_ptr<bus::TrackerMemory> memory_;
    std::unique_ptr<bus::FlightTracker> tracker_;
};

}  // namespace tedavis::test_support
