#include "target/json_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace tedavis::target::test_json_line {
namespace {

TEST(JsonLine, IsReadBackAsItWasWritten) {
    const std::string odd = "a \"quote\", a \\ and a\nline \x01 \xc3\xa4";
    JsonLine line;
    line.open_object().text("t", odd).number("n", std::uint64_t{18446744073709551615u}).number("x", -0.25).boolean("b", true);
    line.open_list("l").open_object().boolean("c", false).close_object().open_object().close_object().close_list();
    line.open_list("e").close_list().number("nan", std::nan("")).close_object();
    const std::string text(line.line());
    EXPECT_EQ(text.back(), '\n');
    EXPECT_EQ(text.find('\n'), text.size() - 1) << "one line";
    const auto read = nlohmann::json::parse(text);
    EXPECT_EQ(read, (nlohmann::json{{"t", odd},
                                    {"n", 18446744073709551615u},
                                    {"x", -0.25},
                                    {"b", true},
                                    {"l", {{{"c", false}}, nlohmann::json::object()}},
                                    {"e", nlohmann::json::array()},
                                    {"nan", nullptr}}));
    EXPECT_FALSE(line.cut());
}

TEST(JsonLine, SaysWhenItIsFull) {
    JsonLine line;
    line.open_list();
    for (int n = 0; n < 8000; ++n) line.text("", "0123456789");
    EXPECT_TRUE(line.cut());
}

}  // namespace
}  // namespace tedavis::target::test_json_line
