// GPIO lines through libgpiod 2.x. Chips are found by looking at every device; gaps in a line's sequence numbers tell
// of dropped edges. Debounce stays in our software, so that live and recorded switches mean the same.
#if defined(TEDAVIS_HAVE_GPIOD) && defined(TEDAVIS_GPIOD_V2)

#include <gpiod.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "bus/switches/gpio_lines.hpp"

namespace tedavis::bus {
namespace {

constexpr const char* kConsumer = "tedavis";
constexpr std::size_t kMaxBurst = 16;  // what the kernel keeps for a line by default
constexpr int kMaxChips = 256;

bool is_called(gpiod_chip* chip, const char* wanted) {
    gpiod_chip_info* info = gpiod_chip_get_info(chip);
    if (info == nullptr) return false;
    const bool called =
        std::strcmp(gpiod_chip_info_get_label(info), wanted) == 0 || std::strcmp(gpiod_chip_info_get_name(info), wanted) == 0;
    gpiod_chip_info_free(info);
    return called;
}

gpiod_chip* open_chip(const char* wanted) {
    for (int number = 0; number < kMaxChips; ++number) {
        char path[32];
        std::snprintf(path, sizeof path, "/dev/gpiochip%d", number);
        gpiod_chip* chip = gpiod_is_gpiochip_device(path) ? gpiod_chip_open(path) : nullptr;
        if (chip == nullptr) continue;
        if (is_called(chip, wanted)) return chip;
        gpiod_chip_close(chip);
    }
    return nullptr;
}

gpiod_line_bias bias_of(LinePull pull) {
    switch (pull) {
        case LinePull::none: return GPIOD_LINE_BIAS_AS_IS;
        case LinePull::off: return GPIOD_LINE_BIAS_DISABLED;
        case LinePull::up: return GPIOD_LINE_BIAS_PULL_UP;
        case LinePull::down: return GPIOD_LINE_BIAS_PULL_DOWN;
    }
    return GPIOD_LINE_BIAS_AS_IS;
}

/// Null with errno set when the kernel or the memory refuses.
gpiod_line_request* request_line(gpiod_chip* chip, unsigned int offset, const SwitchLine& line) {
    gpiod_line_settings* settings = gpiod_line_settings_new();
    gpiod_line_config* lines = gpiod_line_config_new();
    gpiod_request_config* request = gpiod_request_config_new();
    gpiod_line_request* taken = nullptr;
    if (settings != nullptr && lines != nullptr && request != nullptr) {
        gpiod_request_config_set_consumer(request, kConsumer);
        gpiod_line_settings_set_active_low(settings, line.active_low);
        const bool good = gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_INPUT) == 0 &&
                          gpiod_line_settings_set_edge_detection(settings, GPIOD_LINE_EDGE_BOTH) == 0 &&
                          gpiod_line_settings_set_event_clock(settings, GPIOD_LINE_CLOCK_MONOTONIC) == 0 &&
                          gpiod_line_settings_set_bias(settings, bias_of(line.pull)) == 0 &&
                          gpiod_line_config_add_line_settings(lines, &offset, 1, settings) == 0;
        if (good) taken = gpiod_chip_request_lines(chip, request, lines);
    }
    const int reason = errno;
    if (settings != nullptr) gpiod_line_settings_free(settings);
    if (lines != nullptr) gpiod_line_config_free(lines);
    if (request != nullptr) gpiod_request_config_free(request);
    errno = reason;
    return taken;
}

class GpiodV2Lines final : public GpioLines {
public:
    GpiodV2Lines() : buffer_(gpiod_edge_event_buffer_new(kMaxBurst)) {}
    GpiodV2Lines(const GpiodV2Lines&) = delete;
    GpiodV2Lines& operator=(const GpiodV2Lines&) = delete;
    ~GpiodV2Lines() override {
        release();
        if (buffer_ != nullptr) gpiod_edge_event_buffer_free(buffer_);
    }

    bool request(const SwitchConfig& config, base::Error& error) override {
        release();
        if (buffer_ == nullptr) {
            error.message = "no memory for GPIO edges; free some";
            return false;
        }
        for (const SwitchLine& line : config.lines) {
            if (take(line, error)) continue;
            release();
            return false;
        }
        return true;
    }

    void release() override {
        for (std::size_t i = 0; i < count_; ++i) {
            gpiod_line_request_release(taken_[i].request);
            gpiod_chip_close(taken_[i].chip);
        }
        count_ = 0;
    }

    bool read_level(std::size_t line, bool& level) override {
        const int value = line < count_ ? gpiod_line_request_get_value(taken_[line].request, taken_[line].offset) : -1;
        level = value == GPIOD_LINE_VALUE_ACTIVE;
        return value >= 0;
    }

    Burst read_edges(std::size_t line, base::Span<SwitchEdge> out) override {
        if (line >= count_) return {0, false, true};
        Taken& taken = taken_[line];
        const int ready = gpiod_line_request_wait_edge_events(taken.request, 0);
        if (ready == 0 || (ready < 0 && errno == EINTR)) return {};
        if (ready < 0) return {0, false, true};
        const std::size_t room = out.size() < kMaxBurst ? out.size() : kMaxBurst;
        const int got = gpiod_line_request_read_edge_events(taken.request, buffer_, room);
        if (got < 0) return {0, false, true};
        Burst burst{static_cast<std::size_t>(got), false, false};
        for (std::size_t i = 0; i < burst.count; ++i) {
            gpiod_edge_event* event = gpiod_edge_event_buffer_get_event(buffer_, i);
            const unsigned long number = gpiod_edge_event_get_line_seqno(event);
            burst.lost = burst.lost || number != taken.last_number + 1;
            taken.last_number = number;
            const base::Time time{static_cast<std::int64_t>(gpiod_edge_event_get_timestamp_ns(event))};
            out[i] = {time, static_cast<std::uint8_t>(line),
                      gpiod_edge_event_get_event_type(event) == GPIOD_EDGE_EVENT_RISING_EDGE};
        }
        return burst;
    }

private:
    struct Taken {
        gpiod_chip* chip = nullptr;
        gpiod_line_request* request = nullptr;
        unsigned int offset = 0;
        unsigned long last_number = 0;  // the kernel counts a line's edges from 1
    };

    bool take(const SwitchLine& line, base::Error& error) {
        gpiod_chip* chip = open_chip(line.chip.c_str());
        if (chip == nullptr) {
            error = switch_line_error(line, "no GPIO chip has this label or name; see gpiodetect and correct 'chip'");
            return false;
        }
        const int offset = line.offset >= 0 ? line.offset : gpiod_chip_get_line_offset_from_name(chip, line.name.c_str());
        gpiod_line_request* request = offset >= 0 ? request_line(chip, static_cast<unsigned int>(offset), line) : nullptr;
        if (request != nullptr) {
            taken_[count_++] = {chip, request, static_cast<unsigned int>(offset), 0};
            return true;
        }
        if (offset < 0) {
            error = switch_line_error(line, what_is_missing(line));
        } else {
            error = switch_line_error(line, "the kernel refuses the line (");
            error.message.append(std::strerror(errno));
            error.message.append("); free it or correct its settings");
        }
        gpiod_chip_close(chip);
        return false;
    }

    gpiod_edge_event_buffer* buffer_;
    std::array<Taken, kMaxSwitchLines> taken_{};
    std::size_t count_ = 0;
};

}  // namespace

std::unique_ptr<GpioLines> make_gpiod_lines() { return std::make_unique<GpiodV2Lines>(); }

}  // namespace tedavis::bus

#endif
