// GPIO lines through libgpiod 1.x. Its kernel interface neither debounces nor says when it dropped edges; the source
// reads levels again after every burst.
#if defined(TEDAVIS_HAVE_GPIOD) && !defined(TEDAVIS_GPIOD_V2)

#include <gpiod.h>
#include <poll.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "bus/switches/gpio_lines.hpp"

namespace tedavis::bus {
namespace {

constexpr const char* kConsumer = "tedavis";
constexpr std::size_t kMaxBurst = 16;  // what the kernel keeps for a line

int request_flags(const SwitchLine& line) {
    int flags = line.active_low ? GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW : 0;
    switch (line.pull) {
        case LinePull::none: break;
        case LinePull::off: flags |= GPIOD_LINE_REQUEST_FLAG_BIAS_DISABLE; break;
        case LinePull::up: flags |= GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP; break;
        case LinePull::down: flags |= GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN; break;
    }
    return flags;
}

class GpiodV1Lines final : public GpioLines {
public:
    ~GpiodV1Lines() override { release(); }

    bool request(const SwitchConfig& config, base::Error& error) override {
        release();
        for (const SwitchLine& line : config.lines) {
            if (take(line, error)) continue;
            release();
            return false;
        }
        return true;
    }

    void release() override {
        for (std::size_t i = 0; i < count_; ++i) gpiod_chip_close(chips_[i]);  // releases its line as well
        count_ = 0;
    }

    bool read_level(std::size_t line, bool& level) override {
        const int value = line < count_ ? gpiod_line_get_value(lines_[line]) : -1;
        level = value == 1;
        return value >= 0;
    }

    Burst read_edges(std::size_t line, base::Span<SwitchEdge> out) override {
        if (line >= count_) return {0, false, true};
        pollfd waiting{gpiod_line_event_get_fd(lines_[line]), POLLIN, 0};
        const int ready = poll(&waiting, 1, 0);
        if (ready == 0 || (ready < 0 && errno == EINTR)) return {};
        if (ready < 0 || (waiting.revents & POLLIN) == 0) return {0, false, true};
        gpiod_line_event events[kMaxBurst];
        const std::size_t room = out.size() < kMaxBurst ? out.size() : kMaxBurst;
        const int got = gpiod_line_event_read_multiple(lines_[line], events, static_cast<unsigned int>(room));
        if (got < 0) return {0, false, true};
        for (std::size_t i = 0; i < static_cast<std::size_t>(got); ++i) {
            const base::Time time{events[i].ts.tv_sec * std::int64_t{1'000'000'000} + events[i].ts.tv_nsec};
            out[i] = {time, static_cast<std::uint8_t>(line), events[i].event_type == GPIOD_LINE_EVENT_RISING_EDGE};
        }
        return {static_cast<std::size_t>(got), false, false};
    }

private:
    bool take(const SwitchLine& line, base::Error& error) {
        gpiod_chip* chip = gpiod_chip_open_by_label(line.chip.c_str());
        if (chip == nullptr) chip = gpiod_chip_open_lookup(line.chip.c_str());
        if (chip == nullptr) {
            error = switch_line_error(line, "no GPIO chip has this label or name; see gpiodetect and correct 'chip'");
            return false;
        }
        gpiod_line* handle = line.offset >= 0 ? gpiod_chip_get_line(chip, static_cast<unsigned int>(line.offset))
                                              : gpiod_chip_find_line(chip, line.name.c_str());
        if (handle == nullptr) {
            error = switch_line_error(line, what_is_missing(line));
        } else if (gpiod_line_request_both_edges_events_flags(handle, kConsumer, request_flags(line)) != 0) {
            error = switch_line_error(line, "the kernel refuses the line (");
            error.message.append(std::strerror(errno));
            error.message.append("); free it or correct its settings");
        } else {
            chips_[count_] = chip;
            lines_[count_] = handle;
            ++count_;
            return true;
        }
        gpiod_chip_close(chip);
        return false;
    }

    std::array<gpiod_chip*, kMaxSwitchLines> chips_{};
    std::array<gpiod_line*, kMaxSwitchLines> lines_{};
    std::size_t count_ = 0;
};

}  // namespace

std::unique_ptr<GpioLines> make_gpiod_lines() { return std::make_unique<GpiodV1Lines>(); }

}  // namespace tedavis::bus

#endif
