#include "target/command_line.hpp"

#include <charconv>
#include <string_view>

namespace tedavis::target {
namespace {

constexpr std::string_view kSeeHelp = "; see tedavis-display --help";

/// Whole and positive, or 0.
std::uint64_t parse_count(std::string_view text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? value : 0;
}

class Arguments {
public:
    Arguments(int count, const char* const* texts) : count_(count), texts_(texts) {}

    base::Result<CommandLine, base::Error> parse() {
        while (at_ < count_ && !answered_ && !error_) take(texts_[at_++]);
        if (!error_ && line_.request == Request::run && line_.config == nullptr)
            refuse({"--config: is missing; name the board file"});
        if (!error_ && line_.request != Request::run && line_.frames != 0) refuse({"--frames: belongs to a run; leave it out"});
        if (error_) return base::fail(error_);
        return line_;
    }

private:
    void refuse(std::initializer_list<std::string_view> parts) {
        error_ = base::make_error(parts);
        error_.message.append(kSeeHelp);
    }

    const char* value_of(std::string_view option) {
        if (at_ < count_) return texts_[at_++];
        refuse({option, ": needs a value behind it"});
        return nullptr;
    }

    void answer(Request request) {
        line_.request = request;
        line_.frames = 0;
        answered_ = true;
    }

    void take(std::string_view argument) {
        if (argument == "--help" || argument == "-h") return answer(Request::help);
        if (argument == "--version") return answer(Request::version);
        if (argument == "--json") {
            line_.json = true;
        } else if (argument == "--self-test") {
            line_.request = Request::self_test;
        } else if (argument == "--config") {
            line_.config = value_of(argument);
        } else if (argument == "--frames") {
            take_frames(argument);
        } else {
            refuse({"'", argument, "': no such option"});
        }
    }

    void take_frames(std::string_view option) {
        const char* value = value_of(option);
        if (value == nullptr) return;
        line_.frames = parse_count(value);
        if (line_.frames == 0) refuse({"--frames '", value, "': must be a whole number from 1 on"});
    }

    int count_;
    const char* const* texts_;
    int at_ = 0;
    bool answered_ = false;
    CommandLine line_;
    base::Error error_;
};

}  // namespace

base::Result<CommandLine, base::Error> parse_command_line(int count, const char* const* arguments) {
    return Arguments(count, arguments).parse();
}

const char* command_line_help() noexcept {
    return "tedavis-display: the synthetic-vision display of a cockpit board. Advisory only.\n"
           "\n"
           "  tedavis-display --config BOARD.toml [--frames N] [--json]   run until SIGINT or SIGTERM\n"
           "  tedavis-display --self-test [--config BOARD.toml] [--json]  what must hold on this machine, and of a board's "
           "set-up\n"
           "  tedavis-display --help | --version\n"
           "\n"
           "  --config F   the board file; with --self-test, it is started on a trial, and every file that it names is read\n"
           "  --frames N   stop after N frames\n"
           "  --json       results as JSON lines on stdout\n"
           "\n"
           "Exit codes: 0 done, 1 a check did not hold or the display was lost, 2 wrong usage or input.\n";
}

}  // namespace tedavis::target
