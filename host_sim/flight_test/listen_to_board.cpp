#include "host_sim/flight_test/listen_to_board.hpp"

#include <deque>
#include <utility>

#include "host_sim/flight_test/board_records.hpp"

namespace tedavis::host_sim {
namespace {

constexpr base::Duration kListenTurn = base::Duration::milliseconds(100);
constexpr double kLateRecord_s = 1;  // a record comes when its picture is drawn
constexpr base::Duration kLongestSilence = base::Duration::seconds(10);

void hear(BoardPort& port, std::vector<bus::CanFrame>& frames) {
    for (const bus::CanFrame& frame : port.take_received())
        if (frame.kind != bus::FrameKind::error) frames.push_back(frame);
}

/// The log would lack what the display has seen.
void require_all_heard(BoardPort& port, std::uint64_t dropped_before, const std::string& display) {
    const std::uint64_t dropped = port.dropped_frames() - dropped_before;
    if (dropped == 0) return;
    throw UserError(display + ": the kernel has dropped " + std::to_string(dropped) +
                    " frames of the bus, so the log would not be whole; end other programs, and record again");
}

void require_phase_of_bus(const BoardRecord& record, const std::string& display) {
    if (record.seen.record.phase.source == flight::PhaseSource::switches)
        throw UserError(display +
                        ": the panel states the phase, and nobody can hear its edges; set it to leave the phase "
                        "to the bus, and record again");
}

void take(const BoardRecord& record, const ListenSettings& settings, FactTracks& tracks, HeardFlight& heard) {
    if (settings.told) settings.told(record.seen.time_s);
    require_phase_of_bus(record, settings.display);
    if (record.seen.time_s < settings.from_s) return;
    require_on_screen(record, settings.display);
    tracks.take(record.seen);
    ++heard.shown;
}

}  // namespace

HeardFlight listen_to_board(BoardPort& port, const ListenSettings& settings, FactTracks& tracks) {
    HeardFlight heard;
    BoardRecords records(port, settings.display, settings.is_interrupted);
    static_cast<void>(port.take_received());  // of before
    const base::Time begun = port.now();
    const std::uint64_t dropped_before = port.dropped_frames();
    std::deque<BoardRecord> waiting;  // no frame of the bus is heard that is as late as they are
    for (;;) {
        if (std::optional<BoardRecord> record = records.next(port.now() + kListenTurn)) waiting.push_back(std::move(*record));
        hear(port, heard.frames);
        require_all_heard(port, dropped_before, settings.display);
        if (heard.frames.empty()) {
            waiting.clear();
            if (port.now() - begun <= kLongestSilence) continue;
            throw UserError(settings.display + ": the bus of this display says nothing; let the aircraft or a player send on it");
        }
        const base::Time newest = heard.frames.back().time;
        if ((port.now() - heard.frames.front().time).to_seconds() > settings.for_s + kLateRecord_s) return heard;
        for (; !waiting.empty() && waiting.front().monotonic_s <= (newest - base::Time{}).to_seconds(); waiting.pop_front()) {
            BoardRecord& record = waiting.front();
            record.seen.time_s = record.monotonic_s - (heard.frames.front().time - base::Time{}).to_seconds();
            if (record.seen.time_s > settings.for_s) return heard;
            take(record, settings, tracks, heard);
        }
    }
}

}  // namespace tedavis::host_sim
