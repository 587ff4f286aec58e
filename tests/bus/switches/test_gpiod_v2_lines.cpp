// The libgpiod 2.x implementation against a chip of our own: this file defines the library's functions for the whole
// test program. Compiled where libgpiod 2.x is installed.
#if defined(TEDAVIS_HAVE_GPIOD)
#include <gpiod.h>
#endif

#if defined(TEDAVIS_HAVE_GPIOD) && !defined(GPIOD_LINE_BULK_MAX_LINES)  // only libgpiod 1.x has it

#include <gtest/gtest.h>

#include <cerrno>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "bus/switches/gpio_lines.hpp"
#include "tests/bus/switches/switch_fixtures.hpp"

struct gpiod_edge_event {
    std::uint64_t time_ns;
    bool rising;
    unsigned long number;
};
struct gpiod_line_settings {
    gpiod_line_direction direction = GPIOD_LINE_DIRECTION_AS_IS;
    gpiod_line_edge edge = GPIOD_LINE_EDGE_NONE;
    gpiod_line_bias bias = GPIOD_LINE_BIAS_AS_IS;
    gpiod_line_clock clock = GPIOD_LINE_CLOCK_REALTIME;
    bool active_low = false;
};
struct gpiod_line_config {
    unsigned int offset = 0;
    gpiod_line_settings settings;
};
struct gpiod_request_config {};
struct gpiod_line_request {
    gpiod_line_settings settings;
    gpiod_line_value value = GPIOD_LINE_VALUE_INACTIVE;
    std::deque<gpiod_edge_event> events;
    unsigned long numbers = 0;
    bool taken = false;
    bool busy = false;

    void edge(std::uint64_t time_ns, bool rising) {
        value = rising ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE;
        events.push_back({time_ns, rising, ++numbers});
    }
};
struct gpiod_edge_event_buffer {
    std::vector<gpiod_edge_event> events;
};
struct gpiod_chip {
    std::string label, name;
    std::map<std::string, unsigned int> offsets;
    std::map<unsigned int, gpiod_line_request> lines;
    int open = 0;
};
struct gpiod_chip_info {
    gpiod_chip* chip;
};

namespace {
gpiod_chip* plugged = nullptr;  // at /dev/gpiochip3
int living = 0;                 // objects of the library not yet freed

template <class T>
T* made() {
    ++living;
    return new T();
}
template <class T>
void freed(T* object) {
    --living;
    delete object;
}
}  // namespace

extern "C" {

bool gpiod_is_gpiochip_device(const char* path) { return plugged != nullptr && std::string(path) == "/dev/gpiochip3"; }
gpiod_chip* gpiod_chip_open(const char*) {
    ++plugged->open;
    return plugged;
}
void gpiod_chip_close(gpiod_chip* chip) { --chip->open; }
gpiod_chip_info* gpiod_chip_get_info(gpiod_chip* chip) {
    gpiod_chip_info* info = made<gpiod_chip_info>();
    info->chip = chip;
    return info;
}
void gpiod_chip_info_free(gpiod_chip_info* info) { freed(info); }
const char* gpiod_chip_info_get_name(gpiod_chip_info* info) { return info->chip->name.c_str(); }
const char* gpiod_chip_info_get_label(gpiod_chip_info* info) { return info->chip->label.c_str(); }
int gpiod_chip_get_line_offset_from_name(gpiod_chip* chip, const char* name) {
    const auto found = chip->offsets.find(name);
    return found != chip->offsets.end() ? static_cast<int>(found->second) : -1;
}
gpiod_line_settings* gpiod_line_settings_new(void) { return made<gpiod_line_settings>(); }
void gpiod_line_settings_free(gpiod_line_settings* settings) { freed(settings); }
int gpiod_line_settings_set_direction(gpiod_line_settings* settings, gpiod_line_direction direction) {
    settings->direction = direction;
    return 0;
}
int gpiod_line_settings_set_edge_detection(gpiod_line_settings* settings, gpiod_line_edge edge) {
    settings->edge = edge;
    return 0;
}
int gpiod_line_settings_set_bias(gpiod_line_settings* settings, gpiod_line_bias bias) {
    settings->bias = bias;
    return 0;
}
void gpiod_line_settings_set_active_low(gpiod_line_settings* settings, bool active_low) { settings->active_low = active_low; }
int gpiod_line_settings_set_event_clock(gpiod_line_settings* settings, gpiod_line_clock clock) {
    settings->clock = clock;
    return 0;
}
gpiod_line_config* gpiod_line_config_new(void) { return made<gpiod_line_config>(); }
void gpiod_line_config_free(gpiod_line_config* config) { freed(config); }
int gpiod_line_config_add_line_settings(gpiod_line_config* config, const unsigned int* offsets, size_t,
                                        gpiod_line_settings* settings) {
    config->offset = offsets[0];
    config->settings = *settings;
    return 0;
}
gpiod_request_config* gpiod_request_config_new(void) { return made<gpiod_request_config>(); }
void gpiod_request_config_free(gpiod_request_config* config) { freed(config); }
void gpiod_request_config_set_consumer(gpiod_request_config*, const char*) {}
gpiod_line_request* gpiod_chip_request_lines(gpiod_chip* chip, gpiod_request_config*, gpiod_line_config* config) {
    gpiod_line_request& line = chip->lines[config->offset];
    if (line.busy || line.taken) {
        errno = EBUSY;
        return nullptr;
    }
    line.settings = config->settings;
    line.taken = true;
    return &line;
}
void gpiod_line_request_release(gpiod_line_request* request) { request->taken = false; }
gpiod_line_value gpiod_line_request_get_value(gpiod_line_request* request, unsigned int) { return request->value; }
int gpiod_line_request_wait_edge_events(gpiod_line_request* request, int64_t timeout_ns) {
    EXPECT_EQ(timeout_ns, 0) << "the source never waits";
    return request->value == GPIOD_LINE_VALUE_ERROR ? -1 : request->events.empty() ? 0 : 1;
}
int gpiod_line_request_read_edge_events(gpiod_line_request* request, gpiod_edge_event_buffer* buffer, size_t count) {
    buffer->events.clear();
    for (; buffer->events.size() < count && !request->events.empty(); request->events.pop_front())
        buffer->events.push_back(request->events.front());
    return static_cast<int>(buffer->events.size());
}
gpiod_edge_event_buffer* gpiod_edge_event_buffer_new(size_t) { return made<gpiod_edge_event_buffer>(); }
void gpiod_edge_event_buffer_free(gpiod_edge_event_buffer* buffer) { freed(buffer); }
gpiod_edge_event* gpiod_edge_event_buffer_get_event(gpiod_edge_event_buffer* buffer, unsigned long index) {
    return &buffer->events[index];
}
gpiod_edge_event_type gpiod_edge_event_get_event_type(gpiod_edge_event* event) {
    return event->rising ? GPIOD_EDGE_EVENT_RISING_EDGE : GPIOD_EDGE_EVENT_FALLING_EDGE;
}
uint64_t gpiod_edge_event_get_timestamp_ns(gpiod_edge_event* event) { return event->time_ns; }
unsigned long gpiod_edge_event_get_line_seqno(gpiod_edge_event* event) { return event->number; }

}  // extern "C"

namespace tedavis::bus::test_gpiod_v2_lines {
namespace {

class GpiodV2Lines : public testing::Test {
protected:
    gpiod_chip chip;
    std::unique_ptr<GpioLines> lines = make_gpiod_lines();
    base::Error error;

    GpiodV2Lines() {
        chip.label = "p";
        chip.name = "gpiochip3";
        chip.offsets = {{"A", 4}, {"B", 9}, {"C", 2}};
        plugged = &chip;
    }
    ~GpiodV2Lines() override {
        lines.reset();
        plugged = nullptr;
        EXPECT_EQ(chip.open, 0) << "every chip that was opened is closed";
        EXPECT_EQ(living, 0) << "every object of the library is freed";
        for (const auto& [offset, line] : chip.lines) EXPECT_FALSE(line.taken) << offset;
    }
    gpiod_line_request& line(const char* name) { return chip.lines[chip.offsets.at(name)]; }
};

TEST_F(GpiodV2Lines, lines_are_found_by_label_and_by_name_of_the_chip) {
    EXPECT_TRUE(lines->request(three_lines(), error)) << error.message.view();
    EXPECT_TRUE(line("C").taken);
    const SwitchConfig by_name = config_from("[[line]]\nchip='gpiochip3'\nname='B'\n[[pattern]]\nphase='ground'\nhigh=[]\n");
    EXPECT_TRUE(lines->request(by_name, error)) << error.message.view();
    EXPECT_TRUE(line("B").taken);
    EXPECT_FALSE(line("C").taken) << "a new request gives the old lines back";
}

TEST_F(GpiodV2Lines, a_line_without_a_name_is_found_by_its_offset) {
    const SwitchConfig by_offset =
        config_from("[[line]]\nchip='p'\nname='OWN'\noffset=9\n[[pattern]]\nphase='ground'\nhigh=[]\n");
    EXPECT_TRUE(lines->request(by_offset, error)) << error.message.view();
    EXPECT_TRUE(line("B").taken);
    EXPECT_FALSE(line("A").taken);
}

TEST_F(GpiodV2Lines, inputs_report_both_edges_on_the_monotonic_clock_with_bias_and_polarity) {
    const SwitchConfig config = config_from(
        "[[line]]\nchip='p'\nname='A'\nactive_low=true\npull='up'\n[[line]]\nchip='p'\nname='B'\npull='down'\n"
        "[[line]]\nchip='p'\nname='C'\npull='off'\n[[pattern]]\nphase='ground'\nhigh=[]\n");
    ASSERT_TRUE(lines->request(config, error)) << error.message.view();
    for (const char* name : {"A", "B", "C"}) {
        EXPECT_EQ(line(name).settings.direction, GPIOD_LINE_DIRECTION_INPUT);
        EXPECT_EQ(line(name).settings.edge, GPIOD_LINE_EDGE_BOTH);
        EXPECT_EQ(line(name).settings.clock, GPIOD_LINE_CLOCK_MONOTONIC);
    }
    EXPECT_TRUE(line("A").settings.active_low);
    EXPECT_FALSE(line("B").settings.active_low);
    EXPECT_EQ(line("A").settings.bias, GPIOD_LINE_BIAS_PULL_UP);
    EXPECT_EQ(line("B").settings.bias, GPIOD_LINE_BIAS_PULL_DOWN);
    EXPECT_EQ(line("C").settings.bias, GPIOD_LINE_BIAS_DISABLED);
}

TEST_F(GpiodV2Lines, what_cannot_be_had_is_said_and_nothing_is_kept) {
    chip.label = "other";
    EXPECT_FALSE(lines->request(three_lines(), error));
    EXPECT_EQ(error.message.view(), "switch line 'p.A': no GPIO chip has this label or name; see gpiodetect and correct 'chip'");
    chip.label = "p";
    chip.offsets.erase("C");
    EXPECT_FALSE(lines->request(three_lines(), error));
    EXPECT_EQ(error.message.view(),
              "switch line 'p.C': the chip has no line of this name; see gpioinfo and correct 'name', or give its "
              "'offset'");
    EXPECT_FALSE(line("A").taken);
    line("B").busy = true;
    EXPECT_FALSE(lines->request(three_lines(), error));
    EXPECT_EQ(error.message.view(),
              "switch line 'p.B': the kernel refuses the line (Device or resource busy); free it or correct its settings");
}

TEST_F(GpiodV2Lines, levels_are_read) {
    ASSERT_TRUE(lines->request(three_lines(), error));
    line("B").value = GPIOD_LINE_VALUE_ACTIVE;
    bool level = true;
    EXPECT_TRUE(lines->read_level(0, level));
    EXPECT_FALSE(level);
    EXPECT_TRUE(lines->read_level(1, level));
    EXPECT_TRUE(level);
    line("B").value = GPIOD_LINE_VALUE_ERROR;
    EXPECT_FALSE(lines->read_level(1, level));
    EXPECT_FALSE(lines->read_level(3, level)) << "there is no fourth line";
}

TEST_F(GpiodV2Lines, edges_come_with_the_kernels_stamp_and_gaps_in_their_numbers_are_losses) {
    ASSERT_TRUE(lines->request(three_lines(), error));
    SwitchEdge out[8];
    EXPECT_EQ(lines->read_edges(1, out).count, 0u);
    line("B").edge(12'345'678'901, true);
    line("B").edge(13'000'000'001, false);
    GpioLines::Burst burst = lines->read_edges(1, out);
    ASSERT_EQ(burst.count, 2u);
    EXPECT_FALSE(burst.lost);
    EXPECT_EQ(out[0].time.ns, 12'345'678'901);
    EXPECT_TRUE(out[0].level);
    EXPECT_EQ(out[0].line, 1);
    EXPECT_FALSE(out[1].level);
    line("B").numbers += 5;
    line("B").edge(14'000'000'000, true);
    burst = lines->read_edges(1, out);
    EXPECT_TRUE(burst.lost);
    line("B").edge(15'000'000'000, false);
    EXPECT_FALSE(lines->read_edges(1, out).lost) << "told once";
}

TEST_F(GpiodV2Lines, a_full_buffer_leaves_the_rest_for_later) {
    ASSERT_TRUE(lines->request(three_lines(), error));
    for (int i = 0; i < 20; ++i) line("A").edge(static_cast<std::uint64_t>(i), i % 2 == 0);
    SwitchEdge few[3], many[64];
    EXPECT_EQ(lines->read_edges(0, few).count, 3u);
    EXPECT_EQ(lines->read_edges(0, many).count, 16u);
    EXPECT_EQ(lines->read_edges(0, many).count, 1u);
    EXPECT_EQ(many[0].time.ns, 19);
}

TEST_F(GpiodV2Lines, a_line_that_fails_or_was_never_taken_is_a_failure) {
    SwitchEdge out[8];
    EXPECT_TRUE(lines->read_edges(0, out).failed);
    ASSERT_TRUE(lines->request(three_lines(), error));
    line("A").value = GPIOD_LINE_VALUE_ERROR;
    EXPECT_TRUE(lines->read_edges(0, out).failed);
}

}  // namespace
}  // namespace tedavis::bus::test_gpiod_v2_lines

#endif
