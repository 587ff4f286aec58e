#include "host_sim/commands/record_board.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "bus/candump/candump_log_writer.hpp"
#include "bus/socketcan/raw_can_socket.hpp"
#include "host_sim/flight_log/stream_sink.hpp"
#include "host_sim/flight_test/listen_to_board.hpp"
#include "host_sim/flight_test/live_board.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

std::string log_beside(const std::string& script) { return std::filesystem::path(script).replace_extension(".log").string(); }

FlightTest board_input(const RecordOptions& options, const BoardFile& board) {
    if (!options.input.empty()) throw UserError(options.input + " beside --target: record the one or the other");
    if (options.from_s || options.to_s || !options.at_s.empty())
        throw UserError("--from, --to and --at belong to a log; say --for with the seconds to listen");
    if (log_beside(options.output) == options.output)
        throw UserError(options.output + ": the log lies there; name a script (.toml)");
    FlightTest test;
    test.picture.design = board.design;
    test.picture.device = board.device;
    test.picture.bus = board.bus;
    test.picture.aircraft = board.aircraft;
    test.picture.terrain = board.terrain;
    test.picture.scene = board.scene;
    test.switch_config = board.switches.empty() ? ScriptDefaults().switches : board.switches;
    test.log = log_beside(options.output);
    return test;
}

std::uint64_t record_board(BoardPort& port, const RecordOptions& options, std::ostream& log, FactTracks& tracks,
                           Console& console) {
    const InterruptGuard interrupt;
    ListenSettings settings{options.target, options.for_s, kBoardLeadIn_s, [&] { return interrupt.requested(); }, {}};
    settings.told = [&](double done_s) {
        console.progress("listening", static_cast<std::uint64_t>(std::max(done_s, 0.0)),
                         static_cast<std::uint64_t>(options.for_s));
    };
    const HeardFlight heard = listen_to_board(port, settings, tracks);
    console.progress_done();
    const std::array<std::string_view, 1> names{"can0"};
    StreamSink sink(log);
    bus::CandumpLogWriter writer(sink, {names.data(), names.size()}, bus::StampDigits::micro, false);
    for (bus::CanFrame frame : heard.frames) {
        frame.channel = 0;
        if (!writer.write(frame)) throw UserError(log_beside(options.output) + ": cannot be written; check the free space");
    }
    return heard.shown;
}

std::uint64_t record_live_board(const RecordOptions& options, const BoardFile& board, std::ostream& log, FactTracks& tracks,
                                Console& console) {
    bus::RawCanSocket can;
    const std::string& interface = options.interface_name.empty() ? board.interface : options.interface_name;
    LiveBoard live({options.target, interface, "", board.can_fd}, board.panel, can);
    return record_board(live, options, log, tracks, console);
}

}  // namespace tedavis::host_sim
