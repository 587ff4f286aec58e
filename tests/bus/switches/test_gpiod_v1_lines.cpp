// The libgpiod 1.x implementation against a chip of our own: this file defines the library's functions for the whole
// test program. Compiled where libgpiod 1.x is installed.
#if defined(TEDAVIS_HAVE_GPIOD)
#include <gpiod.h>
#endif

#if defined(GPIOD_LINE_BULK_MAX_LINES)  // only libgpiod 1.x has it

#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "bus/switches/gpio_lines.hpp"
#include "tests/bus/switches/switch_fixtures.hpp"

struct gpiod_line {
    int pipe[2] = {-1, -1};  // one byte an edge, so that poll() works as with the kernel
    int value = 0;
    int flags = -1;  // of the request; -1 not requested
    bool busy = false;
    std::deque<gpiod_line_event> events;

    gpiod_line() { EXPECT_EQ(::pipe(pipe), 0); }
    gpiod_line(const gpiod_line&) = delete;
    ~gpiod_line() {
        close(pipe[0]);
        close(pipe[1]);
    }
    void edge(long seconds, long nanoseconds, bool rising) {
        events.push_back({{seconds, nanoseconds}, rising ? GPIOD_LINE_EVENT_RISING_EDGE : GPIOD_LINE_EVENT_FALLING_EDGE});
        value = rising ? 1 : 0;
        EXPECT_EQ(write(pipe[1], "e", 1), 1);
    }
};

struct gpiod_chip {
    std::string label;
    std::string name;
    std::map<std::string, gpiod_line> lines;
    int open = 0;
};

namespace {

gpiod_chip* plugged = nullptr;

}  // namespace

extern "C" {

gpiod_chip* gpiod_chip_open_by_label(const char* label) {
    if (plugged == nullptr || plugged->label != label) return nullptr;
    ++plugged->open;
    return plugged;
}
gpiod_chip* gpiod_chip_open_lookup(const char* description) {
    if (plugged == nullptr || plugged->name != description) return nullptr;
    ++plugged->open;
    return plugged;
}
void gpiod_chip_close(gpiod_chip* chip) { --chip->open; }
gpiod_line* gpiod_chip_find_line(gpiod_chip* chip, const char* name) {
    const auto found = chip->lines.find(name);
    return found != chip->lines.end() ? &found->second : nullptr;
}
gpiod_line* gpiod_chip_get_line(gpiod_chip* chip, unsigned int offset) {
    return offset < chip->lines.size() ? &std::next(chip->lines.begin(), offset)->second : nullptr;
}
int gpiod_line_request_both_edges_events_flags(gpiod_line* line, const char*, int flags) {
    if (line->busy) {
        errno = EBUSY;
        return -1;
    }
    line->flags = flags;
    return 0;
}
int gpiod_line_get_value(gpiod_line* line) { return line->value; }
int gpiod_line_event_get_fd(gpiod_line* line) { return line->pipe[0]; }
int gpiod_line_event_read_multiple(gpiod_line* line, gpiod_line_event* events, unsigned int count) {
    unsigned int got = 0;
    char byte = 0;
    for (; got < count && !line->events.empty() && read(line->pipe[0], &byte, 1) == 1; ++got) {
        events[got] = line->events.front();
        line->events.pop_front();
    }
    return line->value < 0 ? -1 : static_cast<int>(got);
}

}  // extern "C"

namespace tedavis::bus::test_gpiod_v1_lines {
namespace {

class GpiodV1Lines : public testing::Test {
protected:
    gpiod_chip chip;
    std::unique_ptr<GpioLines> lines = make_gpiod_lines();
    base::Error error;

    GpiodV1Lines() {
        chip.label = "p";
        chip.name = "gpiochip3";
        for (const char* name : {"A", "B", "C"}) chip.lines[name].value = 0;
        plugged = &chip;
    }
    ~GpiodV1Lines() override {
        lines.reset();
        EXPECT_EQ(chip.open, 0) << "every chip that was opened is closed";
        plugged = nullptr;
    }
};

TEST_F(GpiodV1Lines, lines_are_found_by_label_and_by_name_of_the_chip) {
    EXPECT_TRUE(lines->request(three_lines(), error)) << error.message.view();
    EXPECT_EQ(chip.open, 3);
    const SwitchConfig by_name = config_from("[[line]]\nchip='gpiochip3'\nname='B'\n[[pattern]]\nphase='ground'\nhigh=[]\n");
    EXPECT_TRUE(lines->request(by_name, error)) << error.message.view();
    EXPECT_EQ(chip.open, 1) << "a new request gives the old lines back";
}

TEST_F(GpiodV1Lines, a_line_without_a_name_is_found_by_its_offset) {
    const auto with_offset = [](int offset) {
        return config_from("[[line]]\nchip='p'\nname='OWN'\noffset=" + std::to_string(offset) +
                           "\npull='up'\n[[pattern]]\nphase='ground'\nhigh=[]\n");
    };
    ASSERT_TRUE(lines->request(with_offset(1), error)) << error.message.view();
    EXPECT_EQ(chip.lines["B"].flags, GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP);
    EXPECT_EQ(chip.lines["A"].flags, -1) << "not asked for";
    EXPECT_FALSE(lines->request(with_offset(3), error));
    EXPECT_EQ(error.message.view(),
              "switch line 'p.OWN': the chip has no line with this offset; see gpioinfo and correct 'offset'");
}

TEST_F(GpiodV1Lines, bias_and_polarity_are_asked_of_the_kernel) {
    const SwitchConfig config = config_from(
        "[[line]]\nchip='p'\nname='A'\nactive_low=true\npull='up'\n[[line]]\nchip='p'\nname='B'\npull='down'\n"
        "[[line]]\nchip='p'\nname='C'\npull='off'\n[[pattern]]\nphase='ground'\nhigh=[]\n");
    ASSERT_TRUE(lines->request(config, error)) << error.message.view();
    EXPECT_EQ(chip.lines["A"].flags, GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW | GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP);
    EXPECT_EQ(chip.lines["B"].flags, GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN);
    EXPECT_EQ(chip.lines["C"].flags, GPIOD_LINE_REQUEST_FLAG_BIAS_DISABLE);
    ASSERT_TRUE(lines->request(three_lines(), error));
    EXPECT_EQ(chip.lines["A"].flags, 0);
}

TEST_F(GpiodV1Lines, what_cannot_be_had_is_said_and_nothing_is_kept) {
    chip.label = "other";
    EXPECT_FALSE(lines->request(three_lines(), error));
    EXPECT_EQ(error.message.view(), "switch line 'p.A': no GPIO chip has this label or name; see gpiodetect and correct 'chip'");
    chip.label = "p";
    chip.lines.erase("C");
    EXPECT_FALSE(lines->request(three_lines(), error));
    EXPECT_EQ(error.message.view(),
              "switch line 'p.C': the chip has no line of this name; see gpioinfo and correct 'name', or give its "
              "'offset'");
    EXPECT_EQ(chip.open, 0);
    chip.lines["B"].busy = true;
    EXPECT_FALSE(lines->request(three_lines(), error));
    EXPECT_EQ(error.message.view(),
              "switch line 'p.B': the kernel refuses the line (Device or resource busy); free it or correct its settings");
    EXPECT_EQ(chip.open, 0);
}

TEST_F(GpiodV1Lines, levels_are_read) {
    ASSERT_TRUE(lines->request(three_lines(), error));
    chip.lines["B"].value = 1;
    bool level = true;
    EXPECT_TRUE(lines->read_level(0, level));
    EXPECT_FALSE(level);
    EXPECT_TRUE(lines->read_level(1, level));
    EXPECT_TRUE(level);
    chip.lines["B"].value = -1;
    EXPECT_FALSE(lines->read_level(1, level));
    EXPECT_FALSE(lines->read_level(3, level)) << "there is no fourth line";
}

TEST_F(GpiodV1Lines, edges_come_with_the_kernels_stamp_and_never_block) {
    ASSERT_TRUE(lines->request(three_lines(), error));
    SwitchEdge out[8];
    EXPECT_EQ(lines->read_edges(1, out).count, 0u);
    chip.lines["B"].edge(12, 345'678'901, true);
    chip.lines["B"].edge(13, 1, false);
    const GpioLines::Burst burst = lines->read_edges(1, out);
    ASSERT_EQ(burst.count, 2u);
    EXPECT_FALSE(burst.failed);
    EXPECT_EQ(out[0].time.ns, 12'345'678'901);
    EXPECT_TRUE(out[0].level);
    EXPECT_EQ(out[0].line, 1);
    EXPECT_EQ(out[1].time.ns, 13'000'000'001);
    EXPECT_FALSE(out[1].level);
    EXPECT_EQ(lines->read_edges(1, out).count, 0u);
    EXPECT_EQ(lines->read_edges(0, out).count, 0u);
}

TEST_F(GpiodV1Lines, a_full_buffer_leaves_the_rest_for_later) {
    ASSERT_TRUE(lines->request(three_lines(), error));
    for (int i = 0; i < 20; ++i) chip.lines["A"].edge(i, 0, i % 2 == 0);
    SwitchEdge few[3], many[64];
    EXPECT_EQ(lines->read_edges(0, few).count, 3u);
    EXPECT_EQ(lines->read_edges(0, many).count, 16u);
    EXPECT_EQ(lines->read_edges(0, many).count, 1u);
    EXPECT_EQ(many[0].time.ns, 19'000'000'000);
}

TEST_F(GpiodV1Lines, a_line_that_fails_or_was_never_taken_is_a_failure) {
    SwitchEdge out[8];
    EXPECT_TRUE(lines->read_edges(0, out).failed);
    ASSERT_TRUE(lines->request(three_lines(), error));
    chip.lines["A"].edge(1, 0, true);
    chip.lines["A"].value = -1;
    EXPECT_TRUE(lines->read_edges(0, out).failed);
}

}  // namespace
}  // namespace tedavis::bus::test_gpiod_v1_lines

#endif
