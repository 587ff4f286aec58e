/// How fast a candump log becomes signals on one core, against a bare newline scan of the same bytes; and how quickly and
/// in how much memory a log of 1 GB is sought into. `--json` prints the lines as a list.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fstream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "bus/canaerospace/message_encoder.hpp"
#include "bus/candump/candump_line.hpp"
#include "bus/candump/candump_log_source.hpp"
#include "bus/state/replay_index.hpp"

namespace {

using namespace tedavis;
using namespace tedavis::bus;

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

/// The block over and over with the seconds of its stamps moved on: a log of any length without a file of that length.
class LongLog final : public base::ByteSource {
public:
    LongLog(const std::string& block, std::uint64_t repeats) : block_(block), repeats_(repeats) {
        for (std::size_t at = 0; at < block.size(); at = block.find('\n', at) + 1) starts_.push_back(at);
    }
    [[nodiscard]] std::uint64_t size() const override { return block_.size() * repeats_; }
    [[nodiscard]] bool read(std::uint64_t offset, void* destination, std::size_t count) override {
        if (offset + count > size()) return false;
        auto* out = static_cast<char*>(destination);
        for (std::size_t done = 0; done < count;) {
            const std::size_t from = (offset + done) % block_.size();
            const std::size_t part = std::min(count - done, block_.size() - from);
            copy_patched((offset + done) / block_.size(), from, part, out + done);
            done += part;
        }
        return true;
    }

private:
    void copy_patched(std::uint64_t repeat, std::size_t from, std::size_t count, char* out) const {
        std::memcpy(out, block_.data() + from, count);
        auto line = std::upper_bound(starts_.begin(), starts_.end(), from);
        if (line != starts_.begin()) --line;
        for (; line != starts_.end() && *line < from + count; ++line) {
            std::int64_t second = std::atoll(block_.data() + *line + 1) + static_cast<std::int64_t>(repeat) * kBlockSeconds;
            for (std::size_t digit = *line + 10; digit > *line; --digit, second /= 10)
                if (digit >= from && digit < from + count) out[digit - from] = static_cast<char>('0' + second % 10);
        }
    }
    const std::string& block_;
    std::uint64_t repeats_;
    std::vector<std::size_t> starts_;
};

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

double resident_peak_mib() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.rfind("VmHWM:", 0) == 0) return std::atof(line.c_str() + 6) / 1024;
    return -1;
}

struct Line {
    std::string name;
    double value;
    const char* unit;
    double target;
    bool holds;
    double baseline;
};

void print_table(const std::vector<Line>& lines) {
    std::printf("%-44s %14s %-10s %12s %6s %12s\n", "name", "value", "unit", "target", "holds", "baseline");
    for (const Line& line : lines)
        std::printf("%-44s %14.4g %-10s %12.4g %6s %12.4g\n", line.name.c_str(), line.value, line.unit, line.target,
                    line.holds ? "yes" : "no", line.baseline);
}

void print_json(const std::vector<Line>& lines) {
    std::printf("[");
    for (std::size_t i = 0; i < lines.size(); ++i)
        std::printf(
            "%s\n  {\"name\": \"%s\", \"value\": %.9g, \"unit\": \"%s\", \"target\": %.9g, \"holds\": %s, \"baseline\": %.9g}",
            i > 0 ? "," : "", lines[i].name.c_str(), lines[i].value, lines[i].unit, lines[i].target,
            lines[i].holds ? "true" : "false", lines[i].baseline);
    std::printf("\n]\n");
}

void measure_decoding(const std::string& text, std::vector<Line>& lines) {
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

void measure_long_log(const std::string& text, std::vector<Line>& lines) {
    LongLog log(text, (1ull << 30) / text.size() + 1);
    std::vector<char> window(256 * 1024);
    CandumpLogSource source(log, {window.data(), window.size()});
    std::vector<ReplayCheckpoint> checkpoints(64);
    auto index = std::make_unique<ReplayIndex>(source, BusSettings(),
                                               base::Span<ReplayCheckpoint>(checkpoints.data(), checkpoints.size()));
    const double indexing = best_seconds(1, [&] {
        while (index->extend(1 << 20)) {
        }
    });
    const base::Duration length = index->extent().last - index->extent().first;
    std::vector<CanFrame> batch(64);
    double slowest = 0;
    for (int i = 1; i < 16; ++i) {
        const base::Time wanted = index->extent().first + base::Duration{length.ns / 16 * i};
        slowest = std::max(slowest, best_seconds(1, [&] {
                               auto assembler = std::make_unique<StateAssembler>(index->seek(wanted));
                               while (const std::size_t count = source.read(wanted, {batch.data(), batch.size()}))
                                   assembler->feed({batch.data(), count});
                           }));
    }
    const double resident = resident_peak_mib();
    lines.push_back({"seek into 1 GiB, slowest of 15", slowest, "s", 1, slowest <= 1, indexing});
    lines.push_back(
        {"peak resident memory, 1 GiB log", resident, "MiB", 256, resident <= 256, static_cast<double>(log.size()) / (1 << 20)});
}

}  // namespace

int main(int argc, char** argv) {
    const bool json = argc == 2 && std::strcmp(argv[1], "--json") == 0;
    if (argc > 1 && !json) {
        std::fprintf(stderr, "bench_decode: unknown argument '%s'; only --json is known\n", argv[1]);
        return 2;
    }
    const std::string text = flight_log();
    std::vector<Line> lines;
    measure_decoding(text, lines);
    measure_long_log(text, lines);
    json ? print_json(lines) : print_table(lines);
    return std::all_of(lines.begin(), lines.end(), [](const Line& line) { return line.holds; }) ? 0 : 1;
}
