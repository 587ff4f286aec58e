#include "bus/switches/gpio_lines.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "tests/bus/switches/switch_fixtures.hpp"

namespace tedavis::bus::test_gpio_lines {
namespace {

TEST(GpioLines, errors_name_the_line_as_the_log_does) {
    EXPECT_EQ(switch_line_error(three_lines().lines[1], "is broken; mend it").message.view(),
              "switch line 'p.B': is broken; mend it");
}

TEST(GpioLines, a_missing_line_is_looked_for_by_what_the_file_says) {
    SwitchLine line = three_lines().lines[1];
    EXPECT_NE(what_is_missing(line).find("no line of this name"), std::string_view::npos);
    line.offset = 0;
    EXPECT_NE(what_is_missing(line).find("no line with this offset"), std::string_view::npos);
}

TEST(GpioLines, libgpiod_is_there_exactly_when_it_was_built_in) {
#if defined(TEDAVIS_HAVE_GPIOD)
    ASSERT_NE(make_gpiod_lines(), nullptr);
    base::Error error;
    EXPECT_FALSE(make_gpiod_lines()->request(three_lines(), error)) << "no machine has a GPIO chip called 'p'";
    EXPECT_EQ(error.message.view(), "switch line 'p.A': no GPIO chip has this label or name; see gpiodetect and correct 'chip'");
#else
    EXPECT_EQ(make_gpiod_lines(), nullptr);
#endif
}

}  // namespace
}  // namespace tedavis::bus::test_gpio_lines
