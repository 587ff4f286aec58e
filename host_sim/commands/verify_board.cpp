#include "host_sim/commands/verify_board.hpp"

#include <algorithm>
#include <filesystem>

#include "bus/socketcan/raw_can_socket.hpp"
#include "host_sim/commands/built_inputs.hpp"
#include "host_sim/flight_test/fly_on_board.hpp"
#include "host_sim/flight_test/input_logs.hpp"
#include "host_sim/flight_test/live_board.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

/// Whether the user named this script, and not a folder that it lies in.
bool is_named(const std::string& path, const VerifyOptions& options) {
    return std::any_of(options.scripts.begin(), options.scripts.end(), [&](const std::string& name) {
        std::error_code error;
        return !std::filesystem::is_directory(name, error) && resolve_config(name, "flight_tests") == path;
    });
}

/// The tests of this board are moved to `kept`.
std::vector<FlownTest> leave_out(std::vector<FlightTest>& tests, const BoardTests& settings, std::vector<FlightTest>& kept) {
    std::vector<FlownTest> left;
    for (FlightTest& test : tests) {
        const std::string misfit = misfit_of(test, settings.board);
        const bool lacks_lines = throws_switches(test) && settings.options.panel_lines.empty();
        const std::string why = misfit.empty() && lacks_lines ? "throws switches, and no --panel-lines are given" : misfit;
        if (!why.empty() && is_named(test.path, settings.options))
            throw UserError(test.path + ": " + why +
                            (misfit.empty() ? "; name the folder of the gpio-sim lines of the board's panel"
                                            : "; fly it on that board, or change the script"));
        if (why.empty())
            kept.push_back(std::move(test));
        else
            left.push_back({std::move(test), {}, "", "", why, ""});
    }
    return left;
}

/// On a board only the logs are needed; terrain and scene are the board's. All are built before the display is connected: while
/// nobody reads, its records pile up, and after some seconds it leaves the reader. Returns a sentence for each test, empty where
/// there is no fault.
std::vector<std::string> resolve_logs(std::vector<FlightTest>& tests, const std::string& folder, Console& console) {
    BuiltInputs inputs(folder, console);
    std::vector<std::string> faults(tests.size());
    for (std::size_t n = 0; n < tests.size(); ++n) {
        tests[n].picture.terrain.clear();
        tests[n].picture.scene.clear();
        try {
            inputs.resolve_to_fly(tests[n]);
        } catch (const UserError& error) {
            faults[n] = error.what();
        } catch (const Interrupted& interrupted) {
            faults[n] = interrupted.what();
        }
    }
    return faults;
}

class BoardSeries {
public:
    BoardSeries(const BoardTests& settings, Console& console)
        : settings_(settings),
          console_(console),
          live_({settings.options.target,
                 settings.options.interface_name.empty() ? settings.board.interface : settings.options.interface_name,
                 settings.options.panel_lines, settings.board.can_fd},
                settings.board.panel, can_) {}

    /// A test with a fault is not begun. Returns false where no further test can be flown.
    bool fly(FlightTest& test, std::string fault, std::vector<FlownTest>& flown) {
        BoardFlightSettings flight{settings_.options.target, settings_.folder,         settings_.board.rate_hz,
                                   settings_.board.designs,  settings_.is_interrupted, {}};
        flight.told = [this, &test](double done_s, double total_s) {
            constexpr double kParts = 10;
            console_.progress(test.path, static_cast<std::uint64_t>(done_s * kParts),
                              static_cast<std::uint64_t>(total_s * kParts));
        };
        bool goes_on = true;
        FlightTestResult result;
        try {
            if (fault.empty()) result = fly_on_board(test, live_, flight);
        } catch (const BoardLost& lost) {
            fault = lost.what();
            goes_on = false;
        } catch (const Interrupted& interrupted) {
            fault = interrupted.what();
        } catch (const UserError& error) {
            fault = error.what();
        }
        goes_on = goes_on && fault != kTestInterrupted;
        console_.progress_done();
        say(test, result, fault);
        flown.push_back({std::move(test), std::move(result), "", "", "", std::move(fault)});
        return goes_on;
    }

private:
    void say(const FlightTest& test, const FlightTestResult& result, const std::string& fault) {
        if (fault == kTestInterrupted) return;  // said once, at the end
        if (!fault.empty()) return console_.note("tedavis: " + test.path + ": " + fault);
        console_.note(test.path + ": " + std::to_string(result.held()) + " of " + std::to_string(result.expectations.size()) +
                      " hold in " + std::to_string(result.frames) + " frames");
    }

    const BoardTests& settings_;
    Console& console_;
    bus::RawCanSocket can_;
    LiveBoard live_;
};

}  // namespace

std::optional<BoardFile> stated_board(const std::string& target, const std::string& board, const std::string& others) {
    if (target.empty() && !(board.empty() && others.empty()))
        throw UserError(
            "--board, --interface and --panel-lines belong to a running display; say --target with its record socket, too");
    if (target.empty()) return std::nullopt;
    if (board.empty()) throw UserError("--target " + target + ": say --board with the file that tedavis-display --config reads");
    return read_board_file(board);
}

std::vector<FlownTest> fly_tests_on_board(std::vector<FlightTest>& tests, const BoardTests& settings, Console& console) {
    std::vector<FlightTest> kept;
    std::vector<FlownTest> flown = leave_out(tests, settings, kept);
    if (kept.empty())
        throw UserError(settings.board.path + ": no script is one of this board (" + flown[0].test.path + " " +
                        flown[0].left_out + "); name others");
    const std::vector<std::string> faults = resolve_logs(kept, settings.folder, console);
    BoardSeries series(settings, console);
    for (std::size_t n = 0; n < kept.size(); ++n) {
        if (series.fly(kept[n], faults[n], flown)) continue;
        const bool is_interrupted = flown.back().fault == kTestInterrupted;
        for (++n; n < kept.size(); ++n)
            flown.push_back({std::move(kept[n]),
                             {},
                             "",
                             "",
                             "",
                             is_interrupted ? kTestInterrupted : "not begun, as the display was gone before"});
    }
    return flown;
}

}  // namespace tedavis::host_sim
