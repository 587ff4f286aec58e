#include "target/command_line.hpp"

#include <charconv>
#include <string_view>

#include "platform/files/file_byte_source.hpp"
#include "platform/runtime/bench_frames.hpp"

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
        if (!error_) refuse_what_does_not_fit();
        if (error_) return base::fail(error_);
        return line_;
    }

private:
    void refuse(std::initializer_list<std::string_view> parts) {
        error_ = base::make_error(parts);
        error_.message.append(kSeeHelp);
    }

    void refuse_what_does_not_fit() {
        const bool is_run = line_.request == Request::run, is_calibration = line_.request == Request::calibrate;
        const bool is_writing = line_.request == Request::write_shaders;
        if ((is_run || is_calibration || is_writing) && line_.config == nullptr)
            return refuse({"--config: is missing; name the board file"});
        if (is_writing && line_.shaders[0] == '\0')
            return refuse({"--write-shaders: is empty; name the folder of programs to write"});
        if (line_.names_pack_key && line_.config == nullptr)
            return refuse({"--pack-key: belongs to --config; name the pack, or leave the key out"});
        if (!is_run && line_.shot != nullptr) return refuse({"--shot: belongs to a run; leave it out"});
        if (line_.shot != nullptr && line_.shot[0] == '\0') return refuse({"--shot: is empty; name the picture to write"});
        if (!is_run && line_.frames != 0) return refuse({"--frames: belongs to a run; leave it out"});
        if (is_calibration && line_.output == nullptr) return refuse({"-o: is missing; name the file of costs to write"});
        if (is_calibration && line_.output[0] == '\0') return refuse({"-o: is empty; name the file of costs to write"});
        if (is_calibration && std::string_view(line_.output) == line_.config)
            return refuse({"-o ", line_.output, ": is the board file; name another file"});
        if (!is_calibration && line_.output != nullptr) return refuse({"-o: belongs to --calibrate; leave it out"});
        if (!is_calibration && has_rounds_) return refuse({"--rounds: belongs to --calibrate; leave it out"});
    }

    const char* value_of(std::string_view option) {
        if (at_ < count_) return texts_[at_++];
        refuse({option, ": needs a value behind it"});
        return nullptr;
    }

    void answer(Request request) {
        line_.request = request;
        line_.frames = 0;
        line_.shot = nullptr;
        answered_ = true;
    }

    void take(std::string_view argument) {
        if (argument == "--help" || argument == "-h") return answer(Request::help);
        if (argument == "--version") return answer(Request::version);
        if (argument == "--json") {
            line_.json = true;
        } else if (argument == "--self-test") {
            line_.request = Request::self_test;
        } else if (argument == "--probe") {
            line_.request = Request::probe;
        } else if (argument == "--calibrate") {
            line_.request = Request::calibrate;
        } else if (argument == "--write-shaders") {
            line_.request = Request::write_shaders;
            line_.shaders = value_of(argument);
        } else if (argument == "-o") {
            line_.output = value_of(argument);
        } else if (argument == "--rounds") {
            take_rounds(argument);
        } else if (argument == "--config") {
            line_.config = value_of(argument);
        } else if (argument == "--pack-key") {
            take_pack_key(argument);
        } else if (argument == "--shot") {
            line_.shot = value_of(argument);
        } else if (argument == "--frames") {
            take_frames(argument);
        } else {
            refuse({"'", argument, "': no such option"});
        }
    }

    /// The file must exist; without it no signature would be asked for.
    void take_pack_key(std::string_view option) {
        const char* value = value_of(option);
        if (value == nullptr) return;
        line_.pack_key = value;
        line_.names_pack_key = true;
        const auto key = platform::open_file(value);
        if (!key.ok()) refuse({"--pack-key ", key.error().message.view()});
    }

    void take_frames(std::string_view option) {
        const char* value = value_of(option);
        if (value == nullptr) return;
        line_.frames = parse_count(value);
        if (line_.frames == 0) refuse({"--frames '", value, "': must be a whole number from 1 on"});
    }

    void take_rounds(std::string_view option) {
        using platform::BenchFrames;
        const char* value = value_of(option);
        if (value == nullptr) return;
        has_rounds_ = true;
        static_assert(BenchFrames::kMinRounds == 3 && BenchFrames::kMaxRounds == 1000, "as messages and help say");
        const std::uint64_t rounds = parse_count(value);
        line_.rounds = static_cast<std::uint32_t>(rounds);
        if (rounds < BenchFrames::kMinRounds || rounds > BenchFrames::kMaxRounds)
            refuse({"--rounds '", value, "': must be a whole number from 3 to 1000"});
    }

    int count_;
    const char* const* texts_;
    int at_ = 0;
    bool answered_ = false, has_rounds_ = false;
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
           "  tedavis-display --config BOARD.toml [--frames N] [--shot P.png] [--json]   run until SIGINT or SIGTERM\n"
           "  tedavis-display --self-test [--config BOARD.toml] [--json]  what must hold on this machine, and of a board's "
           "set-up\n"
           "  tedavis-display --probe [--config BOARD.toml] [--json]      what this machine offers, or why a board does not work "
           "here\n"
           "  tedavis-display --calibrate -o C.toml --config BOARD.toml [--rounds N] [--json]\n"
           "                               measures here what the board's display costs, for [costs] in the board file\n"
           "  tedavis-display --write-shaders DIR --config BOARD.toml [--json]\n"
           "                               makes the programs of a device without a compiler, for [programs] in the board file\n"
           "  tedavis-display --help | --version\n"
           "\n"
           "  --config F   the board file, or the folder of a pack that `tedavis pack` wrote; with --self-test, it is started on "
           "a\n"
           "               trial, and every file that it names is read\n"
           "  --pack-key F the public key of minisign that a pack must be signed with (/etc/tedavis/pack.pub, where it exists)\n"
           "  --frames N   stop after N frames\n"
           "  --shot P     writes the picture of the next frame after SIGUSR1 to P (.png), and that of the last of N frames\n"
           "  --probe      with --config: looks at screen, GL, bus, switches and files of the board, fast, and says in one\n"
           "               sentence each what is wrong and what to do; without it: lists cards, screens, modes, GL, CAN\n"
           "               interfaces and GPIO lines of this machine\n"
           "  --calibrate  measures over the middle of the board's terrain, with its device, surface, size and designs, and its\n"
           "               spatial data if there are any, without bus and panel; stop a display that runs here before\n"
           "  -o F         the costs to write (.toml), which tedavis reads too; after a fault or Ctrl-C nothing is written\n"
           "  --rounds N   frames with and without each effect, 3 to 1000 (15); a third as many of each quality level\n"
           "  --write-shaders D  the new folder of programs; only the driver that made them can load them, so make them on this\n"
           "               board, or with `tedavis shaders` on a desk with the same driver\n"
           "  --json       results as JSON lines on stdout\n"
           "\n"
           "Exit codes: 0 done, 1 a check did not hold, or a run lost its display or lacks its screen, 2 wrong usage or input, "
           "130 a calibration or the writing of programs was stopped.\n";
}

}  // namespace tedavis::target
