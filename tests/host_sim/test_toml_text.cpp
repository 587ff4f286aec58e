#include "host_sim/toml_text.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "render_core/base/config_reader.hpp"

namespace tedavis::host_sim::test_toml_text {
namespace {

using Json = nlohmann::ordered_json;

/// As the reader of configuration files takes it.
Json read_again(const std::string& text) {
    base::ConfigReader reader(text, "x.toml");
    EXPECT_TRUE(reader.ok()) << reader.error().message.view() << "\n" << text;
    return Json::parse(
        reader.json([](const base::StatedFile& stated, std::string_view) { return base::FixedString<1023>(stated.name); }));
}

TEST(TomlText, TablesStandBehindTheValuesOfTheirTable) {
    const Json table =
        Json::parse(R"({"t": {"u": {"x": 1}, "y": 2}, "name": "n", "l": [{"a": true, "in": {"b": [1.5, 2]}}, {}]})");
    EXPECT_EQ(toml_text(table),
              "name = \"n\"\n\n[t]\ny = 2\n\n[t.u]\nx = 1\n\n[[l]]\na = true\n\n[l.in]\nb = [1.5, 2]\n\n[[l]]\n");
}

TEST(TomlText, ReadAgainItIsTheSame) {
    const Json table = Json::parse(
        R"({"double": 0.1, "empty list": [], "exact": 2.0577999999999999, "integer": -7, "large": 1e300, "list": ["a, b", "c"],)"
        R"( "odd \"key\"": {"empty": {}, "x.y": {"z": 1}}, "text": "tab\tquote\" back\\ line\n \u0007 \u00e9", "whole": 3.0})");
    EXPECT_EQ(read_again(toml_text(table)), table) << toml_text(table);
    Json other = table;
    other["double"] = 0.10000000000000002;
    EXPECT_NE(read_again(toml_text(other)), table) << "the control";
}

TEST(TomlText, AStringIsReadBackWhateverItHolds) {
    const std::string text = "a \"quoted\" back\\slash,\ta tab, a bell \x07 and \x7f";
    base::ConfigReader reader("text = " + toml_string(text), "s.toml");
    EXPECT_EQ(reader.root().text("text"), text);
    EXPECT_TRUE(reader.finish()) << reader.error().message.view();
}

}  // namespace
}  // namespace tedavis::host_sim::test_toml_text
