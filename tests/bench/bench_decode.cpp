/// How fast a candump log becomes signals on one core, against a bare newline scan of the same bytes. `--json` prints the
/// lines as a list.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "bus/canaerospace/message_encoder.hpp"
#include "bus/candump/candump_line.hpp"
#include "bus/candump/candump_log_source.hpp"
#include "bus/state/state_assembler.hpp"
#include "tests/bench/bench_result.hpp"

namespace {

using namespace tedavis;
using namespace tedavis::bus;
using bench::BenchResult;

constexpr base::Time kForever{std::numeric_limits<std::int64_t>::max()};
constexpr std::int64_t kFirstSecond = 1'700'000'000;
constexpr int kBlockSeconds = 240;
constexpr int kRuns = 5;

/// The standard's example of a bus: nine values at 80 Hz, 32 at 10 Hz, ten at 1 Hz (section 6).
std::string flight_log() {
    constexpr std::uint16_t kFast[] = {300, 301, 302, 303, 304, 305, 311, 312, 321};
    constexpr std::uint16_t kMedium[] = {314,  315,  316,  317, 319, 320, 322,  1036, 1037, 1038, 1039,
                                         1040, 1046, 1047, 332, 333, 334, 1070, 1121, 1124, 1130, 1131,
                                         1132, 1133, 1069, 327, 328, 329, 313,  1087, 1091, 318};
    constexpr std::uint16_t kSlow[] = {323, 324, 325, 326, 335, 1041, 1042, 1043, 1044, 430};
    MessageEncoder encoder(BusSettings(), 1);
    std::string text;
    CanFrame frames[2];
    char line[kMaxCandumpLine];
    const auto put = [&](std::uint16_t identifier, std::int64_t ns) {
        const IdentifierEntry& entry = identifier_table()[identifier_index(identifier)];
        const double middle =
            0.5 * (entry.low + entry.high) + 0.1 * (entry.high - entry.low) * std::sin(static_cast<double>(ns) * 1e-9);
        const bool position = is_position(entry);
        const std::size_t count = encoder.encode(identifier, middle, position ? DataType::double_high : DataType::float32,
                                                 {kFirstSecond * 1'000'000'000 + ns}, frames);
        for (std::size_t i = 0; i < count; ++i)
            text.append(line, format_candump_line(frames[i], "can0", StampDigits::micro, false, line));
    };
    for (int tick = 0; tick < kBlockSeconds * 80; ++tick) {
        const std::int64_t ns = tick * 12'500'000ll;
        for (const std::uint16_t identifier : kFast) put(identifier, ns);
        if (tick % 8 == 0)
            for (const std::uint16_t identifier : kMedium) put(identifier, ns + 1'000'000);
        if (tick % 80 == 0)
            for (const std::uint16_t identifier : kSlow) put(identifier, ns + 2'000'000);
    }
    return text;
}

/// Processor time, so that other programs on the machine do not count; nothing here waits or uses a second thread.
template <class Work>
double best_seconds(int runs, Work work) {
    double best = 1e300;
    for (int i = 0; i < runs; ++i) {
        const std::clock_t start = std::clock();
        work();
        best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return best;
}

std::uint64_t count_newlines(const std::string& text) {
    std::uint64_t lines = 0;
    const char* at = text.data();
    const char* end = at + text.size();
    while (const void* found = std::memchr(at, '\n', static_cast<std::size_t>(end - at))) {
        ++lines;
        at = static_cast<const char*>(found) + 1;
    }
    return lines;
}

void measure_decoding(const std::string& text, std::vector<BenchResult>& lines) {
    std::uint64_t newlines = 0;
    const double scan = best_seconds(kRuns, [&] { newlines = count_newlines(text); });
    std::vector<CanFrame> batch(64);
    const auto read_all = [&](StateAssembler* assembler) {
        CandumpLogSource source(base::Span<const char>(text.data(), text.size()));
        while (const std::size_t count = source.read(kForever, {batch.data(), batch.size()}))
            if (assembler != nullptr) assembler->feed({batch.data(), count});
    };
    const double parse = best_seconds(kRuns, [&] { read_all(nullptr); });
    auto assembler = std::make_unique<StateAssembler>();
    const double decode = best_seconds(kRuns, [&] {
        *assembler = StateAssembler();
        read_all(assembler.get());
    });
    const BusSnapshot snapshot = assembler->snapshot({});
    const auto frames = static_cast<double>(newlines);
    const bool whole = snapshot.counters.frames == newlines && snapshot.counters.alien == 0;
    const double scan_rate = frames / scan;
    lines.push_back(
        {"decode: line to frame to signal", frames / decode, "frames/s", 5e6, whole && frames / decode >= 5e6, scan_rate});
    lines.push_back({"parse: line to frame", frames / parse, "frames/s", 5e6, frames / parse >= 5e6, scan_rate});
    lines.push_back({"decode time / newline scan time", decode / scan, "ratio", scan_rate / 5e6,
                     whole && decode / scan <= scan_rate / 5e6, 1});
}

}  // namespace

int main(int argc, char** argv) {
    const bool json = argc == 2 && std::strcmp(argv[1], "--json") == 0;
    if (argc > 1 && !json) {
        std::fprintf(stderr, "bench_decode: unknown argument '%s'; only --json is known\n", argv[1]);
        return 2;
    }
    const std::string text = flight_log();
    std::vector<BenchResult> lines;
    measure_decoding(text, lines);
    return bench::report(lines, json);
}
