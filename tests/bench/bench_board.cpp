/// The board program between bus and picture on this machine, without a screen: the time from a CAN frame to the completed
/// picture, and what a full bus costs. A pair of sockets with the kernel's stamps stands for the bus; a thread sends the
/// self-test's flight again and again, at its own pace. `--json` prints the lines as a list.
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <string>
#include <thread>
#include <vector>

#include "bus/candump/candump_log_source.hpp"
#include "bus/socketcan/kernel_frame.hpp"
#include "target/display_application.hpp"
#include "target/self_test.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/support/files/paths.hpp"

namespace {

using namespace tedavis;
using namespace tedavis::target;
using bench::BenchResult;

/// At 1 Mbit/s, of eight bytes and without stuffed bits: 111 bits a frame with the gap before the next.
constexpr int kFullBus = 9009;
constexpr std::uint32_t kForeignId = 0x7F0;

class PairPort final : public bus::CanSocketPort {
public:
    ~PairPort() override {
        if (far_ >= 0) close(far_);
    }
    [[nodiscard]] bus::OpenedSocket open(const bus::SocketCanSettings&) override {
        int ends[2] = {-1, -1};
        const int on = 1, room = 1 << 20;
        if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK, 0, ends) != 0) return {};
        if (setsockopt(ends[0], SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on) != 0) return {};
        if (setsockopt(ends[1], SOL_SOCKET, SO_SNDBUF, &room, sizeof room) != 0) return {};
        far_ = ends[1];
        return {ends[0], {}};
    }
    [[nodiscard]] bool send(const bus::CanFrame& frame) const {
        std::array<unsigned char, bus::kKernelFdFrameBytes> record{};
        const std::size_t size = bus::frame_to_kernel(frame, record);
        return far_ >= 0 && ::send(far_, record.data(), size, MSG_NOSIGNAL) == static_cast<ssize_t>(size);
    }

private:
    std::atomic<int> far_{-1};
};

std::vector<bus::CanFrame> known_flight() {
    bus::CandumpLogSource source(embedded_inputs().log);
    std::vector<bus::CanFrame> frames;
    bus::CanFrame frame;
    while (source.read(base::Time{INT64_MAX}, base::Span<bus::CanFrame>(&frame, 1)) == 1) frames.push_back(frame);
    return frames;
}

/// Sends from its construction to its end, every millisecond what is due.
class BusTraffic {
public:
    /// `frames_a_second`: with foreign frames, or 0 for the flight alone.
    BusTraffic(const PairPort& port, int frames_a_second) : port_(port), rate_(frames_a_second), thread_([this] { run(); }) {}
    ~BusTraffic() {
        stop_ = true;
        thread_.join();
    }
    BusTraffic(const BusTraffic&) = delete;
    BusTraffic& operator=(const BusTraffic&) = delete;
    [[nodiscard]] std::uint64_t sent() const { return sent_; }
    [[nodiscard]] std::uint64_t refused() const { return refused_; }

private:
    void run() {
        const auto begun = std::chrono::steady_clock::now();
        bus::CanFrame foreign;
        foreign.id = kForeignId;
        foreign.length = 8;
        for (std::int64_t ms = 1; !stop_; ++ms) {
            std::this_thread::sleep_until(begun + std::chrono::milliseconds(ms));
            while (next_at_ns() <= ms * 1'000'000) put(flight_[next_++]);
            while (sent_ + refused_ < static_cast<std::uint64_t>(ms) * static_cast<std::uint64_t>(rate_) / 1000) put(foreign);
        }
    }
    /// From the beginning of the thread until the next frame of the flight is due.
    [[nodiscard]] std::int64_t next_at_ns() {
        const std::int64_t length_ns = (flight_.back().time - flight_.front().time).ns + 10'000'000;
        if (next_ == flight_.size()) {
            next_ = 0;
            ++rounds_;
        }
        return rounds_ * length_ns + (flight_[next_].time - flight_.front().time).ns;
    }
    void put(const bus::CanFrame& frame) { ++(port_.send(frame) ? sent_ : refused_); }

    const PairPort& port_;
    std::uint64_t rate_;
    std::vector<bus::CanFrame> flight_ = known_flight();
    std::size_t next_ = 0;
    std::int64_t rounds_ = 0;
    std::atomic<std::uint64_t> sent_{0}, refused_{0};
    std::atomic<bool> stop_{false};
    std::thread thread_;  // last: it uses all others
};

BoardSettings board_settings() {
    const std::string board = test_support::source_dir() + "/tests/target/boards/fake_board.toml";
    auto settings = load_board_settings(board.c_str());
    if (!settings.ok()) std::fprintf(stderr, "bench_board: %s\n", settings.error().message.c_str());
    return settings.ok() ? settings.value() : BoardSettings{};
}

EventLog no_log() {
    return {[](void*, std::string_view) {}, nullptr};
}

void measure_latency(int frames_a_second, const char* name, std::vector<BenchResult>& lines) {
    constexpr std::uint64_t kFrames = 900;
    PairPort port;
    BoardPorts ports;
    ports.can = &port;
    ports.clocks = machine_clocks();
    ports.log = no_log();
    const auto application = std::make_unique<DisplayApplication>(board_settings(), std::move(ports));
    if (application->start()) return lines.push_back({name, 0, "pictures", 2, false, 0});
    const StopSignal stop;
    const BusTraffic traffic(port, frames_a_second);
    const RunReport report = application->run(kFrames, stop);
    const LatencyReport& latency = report.latency;
    const bool whole = report.bus.dropped == 0 && traffic.refused() == 0 && latency.pictures > kFrames / 2;
    lines.push_back({std::string(name) + ", 99 of 100", latency.p99_pictures, "pictures", 2, whole && latency.p99_pictures <= 2,
                     latency.most_pictures});
    lines.push_back({std::string(name) + ", 99 of 100", latency.p99.to_seconds() * 1000, "ms", 2000.0 / 30, whole,
                     latency.median.to_seconds() * 1000});
}

double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Share of a core that reading the bus and tracking the flight take, 30 times a second.
double core_share(int frames_a_second, bool& whole) {
    constexpr int kPictures = 150;
    PairPort port;
    const BoardSettings settings = board_settings();
    const EventLog log = no_log();
    const auto flight = std::make_unique<LiveFlight>(settings, port, nullptr, machine_clocks().live, log);
    const auto display = std::make_unique<display::Display>();
    const BoardClocks clocks = machine_clocks();
    flight->start(clocks.live.monotonic());
    (void)flight->at(clocks.live.monotonic(), display->planner());
    const BusTraffic traffic(port, frames_a_second);
    const base::Time begun = clocks.live.monotonic();
    double used = 0;
    for (int n = 1; n <= kPictures; ++n) {
        std::this_thread::sleep_for(std::chrono::microseconds(33'333));
        const double before = thread_seconds();
        (void)flight->at(clocks.live.monotonic(), display->planner());
        used += thread_seconds() - before;
    }
    const double passed = (clocks.live.monotonic() - begun).to_seconds();
    const bus::BusCounters counters = flight->counters(clocks.live.monotonic());
    const double read = static_cast<double>(counters.frames) / passed;
    whole = traffic.refused() == 0 && counters.dropped == 0 && read > 0.95 * frames_a_second;
    return 100 * used / passed;
}

void measure_load(std::vector<BenchResult>& lines) {
    bool whole = false, base_whole = false;
    const double alone = core_share(0, base_whole), full = core_share(kFullBus, whole);
    lines.push_back({"a full bus of 1 Mbit/s, of a core", full, "%", 3, whole && base_whole && full <= 3, alone});
}

}  // namespace

int main(int argc, char** argv) {
    const bool json = argc == 2 && std::strcmp(argv[1], "--json") == 0;
    if (argc > 1 && !json) {
        std::fprintf(stderr, "bench_board: unknown argument '%s'; only --json is known\n", argv[1]);
        return 2;
    }
    std::vector<BenchResult> lines;
    measure_latency(0, "CAN frame to picture", lines);
    measure_latency(kFullBus, "CAN frame to picture, full bus", lines);
    measure_load(lines);
    return bench::report(lines, json);
}
