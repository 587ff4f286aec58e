#include "bus/switches/gpiod_source.hpp"

#include <utility>

namespace tedavis::bus {
namespace {

constexpr std::size_t kBurst = 16;
constexpr int kMaxBursts = 4;  // a line that chatters faster than this waits for the next call

std::uint32_t bit_of(std::size_t line) { return std::uint32_t{1} << line; }

}  // namespace

GpiodSource::GpiodSource(std::unique_ptr<GpioLines> lines) : lines_(std::move(lines)) {}
GpiodSource::~GpiodSource() { close(); }

base::Result<GpiodSource::Opened, base::Error> GpiodSource::open(const SwitchConfig& config, base::Time now,
                                                                 base::Duration monotonic_to_source) {
    close();
    health_ = SourceHealth::failed;
    base::Error error;
    if (lines_ == nullptr) {
        error.message = "phase switches: this program was built without libgpiod; install libgpiod-dev and build again";
        return base::fail(error);
    }
    if (!lines_->request(config, error)) return base::fail(error);
    line_count_ = config.lines.size();
    offset_ = monotonic_to_source;
    for (std::size_t line = 0; line < line_count_; ++line) {
        bool level = false;
        if (!lines_->read_level(line, level)) {
            fail();
            error.message = "phase switches: a level cannot be read; check the GPIO chip";
            return base::fail(error);
        }
        keep({now, static_cast<std::uint8_t>(line), level});
    }
    health_ = SourceHealth::running;
    return Opened{};
}

void GpiodSource::close() {
    if (lines_ != nullptr && line_count_ > 0) lines_->release();
    line_count_ = 0;
    seen_ = {};
    waiting_.clear();
    health_ = SourceHealth::idle;
}

void GpiodSource::fail() {
    close();
    health_ = SourceHealth::failed;
}

void GpiodSource::keep(const SwitchEdge& edge) {
    if (!waiting_.try_push_back(edge)) {
        ++statistics_.overruns;
        seen_.known &= ~bit_of(edge.line);
        return;
    }
    for (std::size_t i = waiting_.size() - 1; i > 0 && waiting_[i].time < waiting_[i - 1].time; --i)
        std::swap(waiting_[i], waiting_[i - 1]);
    seen_.known |= bit_of(edge.line);
    seen_.high = edge.level ? seen_.high | bit_of(edge.line) : seen_.high & ~bit_of(edge.line);
}

std::size_t GpiodSource::drain(std::size_t line) {
    std::size_t total = 0;
    for (int i = 0; i < kMaxBursts; ++i) {
        SwitchEdge edges[kBurst];
        const GpioLines::Burst burst = lines_->read_edges(line, edges);
        if (burst.failed) {
            fail();
            return 0;
        }
        if (burst.lost) ++statistics_.overruns;
        for (std::size_t k = 0; k < burst.count; ++k) keep({edges[k].time + offset_, edges[k].line, edges[k].level});
        total += burst.count;
        if (burst.count < kBurst) break;
    }
    return total;
}

void GpiodSource::collect(std::size_t line, base::Time until) {
    const bool all_seen = (seen_.known & bit_of(line)) != 0;
    if (drain(line) == 0 && all_seen) return;
    // An edge between the last burst and the reading of the level is no loss: look for it once more.
    for (int attempt = 0; attempt < 2 && health_ == SourceHealth::running; ++attempt) {
        ++statistics_.rereads;
        bool level = false;
        if (!lines_->read_level(line, level)) return fail();
        if ((seen_.known & bit_of(line)) != 0 && level == ((seen_.high & bit_of(line)) != 0)) return;
        if (drain(line) > 0 || health_ != SourceHealth::running) continue;
        if (all_seen) ++statistics_.overruns;
        return keep({until, static_cast<std::uint8_t>(line), level});
    }
    seen_.known &= ~bit_of(line);  // still chattering: read again at the next call
}

std::size_t GpiodSource::read(base::Time until, base::Span<SwitchEdge> out) {
    for (std::size_t line = 0; line < line_count_ && health_ == SourceHealth::running; ++line) collect(line, until);
    std::size_t count = 0;
    while (count < out.size() && count < waiting_.size() && waiting_[count].time <= until) {
        out[count] = waiting_[count];
        ++count;
    }
    const std::size_t left = waiting_.size() - count;
    for (std::size_t i = 0; i < left; ++i) waiting_[i] = waiting_[i + count];
    waiting_.truncate(left);
    statistics_.edges += count;
    return count;
}

}  // namespace tedavis::bus
