#include "render_core/base/config_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

namespace tedavis::base::test_config_reader {
namespace {

using ::testing::HasSubstr;
using Loader = std::function<void(ConfigSection)>;

/// The error sentence after `load`, or "" when everything held.
std::string error_text_of(const std::string& text, const Loader& load) {
    ConfigReader reader(text, "x.toml");
    load(reader.root());
    return reader.finish() ? std::string() : std::string(reader.error().message.view());
}

TEST(ConfigReader, KeepsAllFaultsAndOneForEachValue) {
    ConfigReader reader("a = 9\nb = true\n[t]\n", "f.toml");
    ConfigSection root = reader.root();
    root.integer("a", 0, 5);
    root.fault("a", "is odd; choose an even number");
    root.number("b", 0, 1);
    ConfigSection table = root.section("t");
    table.number("c", 0, 1);
    table.number("d", 0, 1);
    EXPECT_FALSE(reader.finish());
    ASSERT_EQ(reader.errors().size(), 4u);
    const char* places[] = {"f.toml:1: ", "f.toml:2: ", "f.toml:3: key 'c'", "f.toml:3: key 'd'"};
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(reader.errors()[i].message.view().substr(0, std::string_view(places[i]).size()), places[i]);
    EXPECT_EQ(reader.errors()[0].message.view(), reader.error().message.view());
}

TEST(ConfigReader, SaysEveryKeyThatNobodyRead) {
    ConfigReader reader("a = 1\nb = 2\n[t]\nc = 3\n", "f.toml");
    reader.root().integer("a", 0, 5);
    EXPECT_FALSE(reader.finish());
    EXPECT_EQ(reader.errors().size(), 2u) << "b, and t as a whole";
    ConfigReader whole("a = 1\n", "f.toml");
    whole.root().integer("a", 0, 5);
    EXPECT_TRUE(whole.finish());
    EXPECT_TRUE(whole.errors().empty());
    EXPECT_FALSE(whole.error());
}

TEST(ConfigReader, AFileThatIsNotTomlHasThatFaultAlone) {
    ConfigReader reader("a = = 1\n", "f.toml");
    reader.root().integer("a", 0, 5);
    reader.root().text("b");
    EXPECT_FALSE(reader.finish());
    EXPECT_EQ(reader.errors().size(), 1u);
}

TEST(ConfigReader, reads_every_kind_of_value) {
    ConfigReader reader("name = 'alps'\nn = 7\nx = 2.5\nwhole = 3\non = true\nv = [1, 2.5]\nlist = ['a', 'b']\n", "x.toml");
    ConfigSection root = reader.root();
    EXPECT_EQ(root.text("name"), "alps");
    EXPECT_EQ(root.integer("n", 0, 10), 7);
    EXPECT_EQ(root.number("x", 0, 10), 2.5);
    EXPECT_EQ(root.number("whole", 0, 10), 3.0) << "a whole number is a number";
    EXPECT_TRUE(root.boolean("on", false));
    std::array<double, 2> v{};
    root.numbers("v", 0, 10, v);
    EXPECT_EQ(v[1], 2.5);
    std::array<std::string_view, 3> list;
    EXPECT_EQ(root.texts("list", list), 2u);
    EXPECT_EQ(list[1], "b");
    EXPECT_TRUE(reader.finish()) << reader.error().message.view();
    EXPECT_TRUE(reader.ok());
}

TEST(ConfigReader, absent_keys_take_their_fallbacks) {
    ConfigReader reader("", "x.toml");
    ConfigSection root = reader.root();
    EXPECT_EQ(root.number("x", 0, 1, 0.5), 0.5);
    EXPECT_EQ(root.integer("n", 0, 9, 4), 4);
    EXPECT_TRUE(root.boolean("b", true));
    EXPECT_EQ(root.text("t", "none"), "none");
    std::array<double, 2> v{5, 6};
    root.numbers("v", 0, 10, v);
    EXPECT_EQ(v[0], 5);
    EXPECT_EQ(root.texts("l", Span<std::string_view>()), 0u);
    EXPECT_EQ(root.table_count("tables"), 0u);
    EXPECT_FALSE(root.section("s").present());
    EXPECT_EQ(root.section("s").number("x", 0, 1, 0.25), 0.25) << "an absent section reads as empty";
    EXPECT_TRUE(reader.finish());
}

TEST(ConfigReader, faults_name_file_line_key_and_range) {
    const auto number = [](ConfigSection s) { s.number("x", -1, 2.5); };
    EXPECT_EQ(error_text_of("\n\nx = 3", number), "x.toml:3: 'x' must be a number from -1 to 2.5");
    EXPECT_EQ(error_text_of("x = 'three'", number), "x.toml:1: 'x' must be a number from -1 to 2.5");
    EXPECT_EQ(error_text_of("y = 3", number), "x.toml:1: key 'x' is missing; add it");
    EXPECT_EQ(error_text_of("x = 2.5", number), "") << "the bounds are inside";
    EXPECT_EQ(error_text_of("x = -1", number), "");
    const auto integer = [](ConfigSection s) { s.integer("n", 0, 9); };
    EXPECT_EQ(error_text_of("# a\nn = 10", integer), "x.toml:2: 'n' must be a whole number from 0 to 9");
    EXPECT_EQ(error_text_of("n = 1.0", integer), "x.toml:1: 'n' must be a whole number from 0 to 9");
    EXPECT_EQ(error_text_of("n = true", integer), "x.toml:1: 'n' must be a whole number from 0 to 9");
    EXPECT_EQ(error_text_of("b = 1", [](ConfigSection s) { s.boolean("b", false); }), "x.toml:1: 'b' must be true or false");
    EXPECT_EQ(error_text_of("t = 1", [](ConfigSection s) { s.text("t"); }), "x.toml:1: 't' must be a text in quotes");
}

TEST(ConfigReader, a_key_may_be_a_boolean_or_one_word) {
    enum class Kept { never, always, sometimes };
    const auto read = [](const std::string& text, Kept before, std::string& fault) {
        Kept kept = before;
        fault = error_text_of(text, [&](ConfigSection s) { s.boolean_or("kept", "sometimes", kept); });
        return kept;
    };
    std::string fault;
    EXPECT_EQ(read("kept = true", Kept::never, fault), Kept::always);
    EXPECT_EQ(read("kept = false", Kept::always, fault), Kept::never);
    EXPECT_EQ(read("kept = 'sometimes'", Kept::never, fault), Kept::sometimes);
    EXPECT_EQ(read("", Kept::sometimes, fault), Kept::sometimes) << "absent";
    EXPECT_EQ(fault, "");
    for (const char* wrong : {"kept = 1", "kept = 'true'", "kept = 'Sometimes'", "kept = ['sometimes']", "kept = ''"}) {
        EXPECT_EQ(read(std::string("\n") + wrong, Kept::always, fault), Kept::never) << wrong;
        EXPECT_EQ(fault, "x.toml:2: 'kept' must be true, false or \"sometimes\"") << wrong;
    }
}

TEST(ConfigReader, nan_and_infinities_are_refused) {
    const auto number = [](ConfigSection s) { s.number("x", -1e300, 1e300, 0); };
    for (const char* value : {"nan", "-nan", "+nan", "inf", "-inf"})
        EXPECT_EQ(error_text_of(std::string("x = ") + value, number), "x.toml:1: 'x' must be a number from -1e+300 to 1e+300")
            << value;
    std::array<double, 2> v{};
    EXPECT_EQ(error_text_of("v = [1, nan]", [&](ConfigSection s) { s.numbers("v", 0, 5, v); }),
              "x.toml:1: 'v' must be 2 numbers from 0 to 5");
}

TEST(ConfigReader, lists_must_have_the_right_length_and_kind) {
    std::array<double, 2> v{};
    const auto numbers = [&](ConfigSection s) { s.numbers("v", 0, 5, v); };
    EXPECT_NE(error_text_of("v = [1]", numbers), "");
    EXPECT_NE(error_text_of("v = [1, 2, 3]", numbers), "");
    EXPECT_NE(error_text_of("v = 1", numbers), "");
    EXPECT_NE(error_text_of("v = [1, 'two']", numbers), "");
    std::array<std::string_view, 2> list;
    const auto texts = [&](ConfigSection s) { s.texts("l", list); };
    EXPECT_EQ(error_text_of("l = ['a', 'b', 'c']", texts), "x.toml:1: 'l' must be a list of at most 2 texts");
    EXPECT_NE(error_text_of("l = ['a', 2]", texts), "");
    EXPECT_NE(error_text_of("l = 'a'", texts), "");
}

enum class Light : std::uint8_t { none, day, night };
constexpr std::array<std::string_view, 3> kLights = {"none", "day", "night"};

TEST(ConfigReader, a_name_chooses_the_value_of_an_enumeration) {
    ConfigReader reader("light = 'night'\nmode = 'fast'\nwhich = 'c'\n", "x.toml");
    Light light = Light::day;
    reader.root().choose("absent", kLights, light);
    EXPECT_EQ(light, Light::day) << "an absent key leaves the value";
    reader.root().choose("light", kLights, light);
    EXPECT_EQ(light, Light::night);
    constexpr std::string_view kModes[] = {"slow", "fast"}, kLetters[] = {"a", "b", "c"};
    bool is_fast = false;
    reader.root().choose("mode", kModes, is_fast);
    EXPECT_TRUE(is_fast);
    std::size_t which = 0;
    reader.root().choose("which", kLetters, which);
    EXPECT_EQ(which, 2u);
    constexpr std::string_view kOtherOrder[] = {"night", "day"};
    reader.root().choose("light", kOtherOrder, light);
    EXPECT_EQ(light, Light::none) << "the place among the names counts, not the name";
    EXPECT_TRUE(reader.finish()) << reader.error().message.view();
}

TEST(ConfigReader, names_may_begin_with_a_later_value) {
    constexpr std::string_view kLit[] = {"day", "night"};
    ConfigReader reader("light = 'night'", "x.toml");
    Light light = Light::none;
    reader.root().choose("absent", kLit, light, Light::day);
    EXPECT_EQ(light, Light::none);
    reader.root().choose("light", kLit, light, Light::day);
    EXPECT_EQ(light, Light::night);
    reader.root().choose("light", kLit, light);
    EXPECT_EQ(light, Light::day) << "without a first value the names begin with value 0";
}

TEST(ConfigReader, a_faulty_choice_sets_the_first_value_and_lists_the_names) {
    for (const char* text : {"light = 'dusk'", "light = 'Night'", "light = ''"}) {
        ConfigReader reader(text, "x.toml");
        Light light = Light::night;
        reader.root().choose("light", kLights, light);
        EXPECT_EQ(light, Light::none) << text;
        EXPECT_EQ(reader.error().message.view(), "x.toml:1: 'light' must be one of: none, day, night") << text;
    }
    Light light = Light::none;
    const auto load = [&](ConfigSection s) { s.choose("light", kLights, light); };
    EXPECT_EQ(error_text_of("light = 2", load), "x.toml:1: 'light' must be a text in quotes") << "an index is no name";
    EXPECT_EQ(error_text_of("light = 'night'", load), "") << "a name of the list is no fault";
    EXPECT_EQ(light, Light::night);
}

TEST(ConfigReader, arrays_say_how_long_they_are) {
    ConfigReader reader("v = [1, 2, 3]\ne = []\nx = 4", "x.toml");
    EXPECT_EQ(reader.root().element_count("v"), 3u);
    EXPECT_EQ(reader.root().element_count("e"), 0u);
    EXPECT_EQ(reader.root().element_count("none"), 0u);
    EXPECT_TRUE(reader.ok());
    EXPECT_EQ(reader.root().element_count("x"), 0u);
    EXPECT_EQ(reader.error().message.view(), "x.toml:3: 'x' must be an array such as [1, 2]");
}

TEST(ConfigReader, unknown_keys_are_found_at_every_depth) {
    const auto nothing = [](ConfigSection) {};
    EXPECT_EQ(error_text_of("typo = 1", nothing), "x.toml:1: unknown key 'typo'; correct or remove it");
    const auto section = [](ConfigSection s) { s.section("a").number("x", 0, 9); };
    EXPECT_EQ(error_text_of("[a]\nx = 1\n\nz = 2", section), "x.toml:4: unknown key 'a.z'; correct or remove it");
    EXPECT_EQ(error_text_of("[a]\nx = 1\n[b]\ny = 2", section), "x.toml:3: unknown key 'b'; correct or remove it");
    const auto tables = [](ConfigSection s) {
        for (std::size_t i = 0; i < s.table_count("t"); ++i) s.table_at("t", i).integer("n", 0, 9);
    };
    EXPECT_EQ(error_text_of("[[t]]\nn = 1\n[[t]]\nn = 2\nm = 3", tables), "x.toml:5: unknown key 't.m'; correct or remove it");
    EXPECT_EQ(error_text_of("[[t]]\nn = 1\n[[t]]\nn = 2", tables), "");
}

TEST(ConfigReader, the_first_fault_is_kept) {
    const auto load = [](ConfigSection s) {
        s.number("b", 0, 1);
        s.number("a", 0, 1);
    };
    EXPECT_EQ(error_text_of("a = 5\nb = 6", load), "x.toml:2: 'b' must be a number from 0 to 1");
}

TEST(ConfigReader, a_faulty_read_returns_a_value_in_range) {
    ConfigReader reader("x = 50\nn = 'a'\n", "x.toml");
    EXPECT_EQ(reader.root().number("x", 1, 2), 1);
    EXPECT_EQ(reader.root().integer("n", 3, 4, 4), 3);
    EXPECT_EQ(reader.root().text("absent"), "");
    EXPECT_FALSE(reader.ok());
}

TEST(ConfigReader, broken_toml_is_one_sentence_with_its_line) {
    for (const char* text : {"a = 1\nb = \n", "a = 1\n[[[", "a = 1\na = 2", "a = 1\n\"\xff\" = 2", "a = 1\nb = 'unfinished"}) {
        const std::string message = error_text_of(text, [](ConfigSection s) { s.number("a", 0, 9, 0); });
        EXPECT_EQ(message.rfind("x.toml:2: ", 0), 0u) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
}

TEST(ConfigReader, sections_and_tables_must_be_what_they_are_read_as) {
    EXPECT_EQ(error_text_of("a = 1", [](ConfigSection s) { s.section("a"); }), "x.toml:1: 'a' must be a table");
    EXPECT_EQ(error_text_of("a = [1, 2]", [](ConfigSection s) { (void)s.table_count("a"); }),
              "x.toml:1: 'a' must be written as [[a]] tables");
    EXPECT_EQ(error_text_of("[a]\nx = 1", [](ConfigSection s) { (void)s.table_count("a"); }),
              "x.toml:1: 'a' must be written as [[a]] tables");
    ConfigReader reader("[[t]]\n", "x.toml");
    EXPECT_FALSE(reader.root().table_at("t", 1).present()) << "past the end is absent";
    EXPECT_FALSE(reader.root().table_at("u", 0).present());
}

TEST(ConfigReader, tables_whose_names_are_data_are_iterated_in_order) {
    ConfigReader reader("[b]\nn = 2\n[a]\nn = 1\n", "x.toml");
    ConfigSection root = reader.root();
    ASSERT_EQ(root.key_count(), 2u);
    EXPECT_EQ(root.key_at(0), "a");
    EXPECT_EQ(root.key_at(1), "b");
    EXPECT_EQ(root.key_at(2), "");
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_EQ(root.section(root.key_at(i)).integer("n", 0, 9), static_cast<std::int64_t>(i + 1));
    EXPECT_TRUE(reader.finish());
}

TEST(ConfigReader, a_loader_reports_its_own_faults_at_the_keys_line) {
    EXPECT_EQ(error_text_of("a = 1\nb = 2",
                            [](ConfigSection s) {
                                s.integer("a", 0, 9);
                                s.integer("b", 0, 9);
                                s.fault("b", "'b' must not exceed 'a'");
                            }),
              "x.toml:2: 'b' must not exceed 'a'");
}

TEST(ConfigReader, a_sentence_too_long_is_cut_not_lost) {
    ConfigReader reader(std::string(2000, 'k') + " = 1", "x.toml");
    EXPECT_FALSE(reader.finish());
    EXPECT_TRUE(reader.error().message.cut());
    EXPECT_EQ(reader.error().message.view().substr(0, 10), "x.toml:1: ");
}

/// A reader of "x.toml" that inherits from "base.toml".
struct Inheriting {
    ConfigReader reader;
    Inheriting(const std::string& text, const std::string& base, Span<const std::string_view> own = {}) : reader(text, "x.toml") {
        reader.inherit(base, "base.toml", own);
    }
    std::string json() {
        return std::string(reader.json([](const StatedFile& stated, std::string_view own_file) {
            return FixedString<1023>(std::string(own_file) + " from " + std::string(stated.stated_in) + ": " +
                                     std::string(stated.name));
        }));
    }
};

std::string without_blanks(std::string text) {
    text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == ' ' || c == '\n'; }), text.end());
    return text;
}

TEST(ConfigReader, what_a_file_does_not_say_its_base_says) {
    Inheriting both("a = 1\n[t]\nb = 2\n[t.deep]\nc = 3\n",
                    "a = 10\nd = 40\n[t]\nb = 20\ne = 50\n[t.deep]\nf = 60\n[u]\ng = 70\n");
    EXPECT_EQ(without_blanks(both.json()), R"({"a":1,"d":40,"t":{"b":2,"deep":{"c":3,"f":60},"e":50},"u":{"g":70}})");
    Inheriting kinds("a = [1]\n[b]\nx = 1\n", "a = [2, 3]\nb = 4\n");
    EXPECT_EQ(without_blanks(kinds.json()), R"({"a":[1],"b":{"x":1}})") << "lists of numbers, and unlike kinds, are one's own";
}

TEST(ConfigReader, lists_of_tables_inherit_by_name) {
    const std::string base = "[[l]]\nname = 'p'\nx = 1\n[l.in]\ny = 2\n[[l]]\nx = 3\n[[l]]\nname = 'q'\nx = 4\n";
    EXPECT_EQ(without_blanks(
                  Inheriting("[[l]]\nname = 'q'\nx = 40\n[[l]]\nname = 'r'\n[[l]]\nname = 'p'\n[l.in]\nz = 5\n", base).json()),
              R"({"l":[{"in":{"y":2,"z":5},"name":"p","x":1},{"x":3},{"name":"q","x":40},{"name":"r"}]})");
    EXPECT_EQ(without_blanks(Inheriting("[[l]]\nname = 'q'\n[[l]]\nx = 7\n", base).json()), R"({"l":[{"name":"q"},{"x":7}]})")
        << "a list with a table without name is one's own";
    EXPECT_EQ(without_blanks(Inheriting("l = []\n", base).json()), R"({"l":[]})");
    EXPECT_EQ(without_blanks(Inheriting("[[l]]\nname = 'p'\n[[l]]\nname = 'p'\nx = 9\n", "[[l]]\nname = 'p'\nx = 1\n").json()),
              R"({"l":[{"name":"p","x":1},{"name":"p","x":9}]})")
        << "the second of a name stays what it is";
    EXPECT_EQ(without_blanks(Inheriting("", base).json()), without_blanks(Inheriting(base, "").json()));
}

TEST(ConfigReader, a_base_keeps_its_own_keys) {
    constexpr std::string_view kOwn[] = {"name", "phases"};
    Inheriting both("", "name = 'b'\nx = 1\n[phases]\ny = 2\n[t]\nname = 'kept'\n", kOwn);
    EXPECT_EQ(without_blanks(both.json()), R"({"t":{"name":"kept"},"x":1})");
}

TEST(ConfigReader, faults_name_the_file_that_is_wrong) {
    const auto message_of = [](const std::string& text, const std::string& base) {
        Inheriting both(text, base);
        ConfigSection root = both.reader.root();
        root.section("t").number("x", 0, 5, 0);
        if (root.table_count("l") > 0) root.table_at("l", 0).text("name");
        return both.reader.finish() ? "" : std::string(both.reader.error().message.view());
    };
    EXPECT_EQ(message_of("[t]\n", "\n[t]\nx = 6\n"), "base.toml:3: 'x' must be a number from 0 to 5");
    EXPECT_EQ(message_of("[t]\nx = 7\n", "\n[t]\nx = 1\n"), "x.toml:2: 'x' must be a number from 0 to 5");
    EXPECT_EQ(message_of("[t]\nx = 1\n", "\n[t]\nx = 6\n"), "") << "what is said anew is not looked at";
    EXPECT_EQ(message_of("[t]\n", "[t]\n\n\ny = 1\n"), "base.toml:4: unknown key 't.y'; correct or remove it");
    EXPECT_EQ(message_of("[[l]]\nname = 'a'\n", "[[l]]\nname = 'a'\nz = 1\n"),
              "base.toml:3: unknown key 'l.z'; correct or remove it");
    EXPECT_EQ(message_of("", "[[l]]\n"), "base.toml:1: key 'name' is missing; add it");
    EXPECT_THAT(message_of("", "x = 1\nx = 2\n"), HasSubstr("base.toml:2: "));
}

TEST(ConfigReader, a_key_that_is_removed_is_inherited) {
    ConfigReader reader("a = 'own'\n", "x.toml");
    EXPECT_EQ(reader.root().text("a"), "own");
    reader.root().remove("a");
    reader.root().remove("absent");
    EXPECT_FALSE(reader.root().has("a"));
    reader.inherit("a = 'base'\n", "base.toml", {});
    EXPECT_FALSE(reader.finish()) << "nobody has read that of the base";
    EXPECT_EQ(reader.error().message.view(), "base.toml:1: unknown key 'a'; correct or remove it");
}

TEST(ConfigReader, files_know_who_states_them) {
    Inheriting both("own = 'a.txt'\nwrong = 1\n", "inherited = 'b.txt'\ntext = 'c.txt'\n");
    ConfigSection root = both.reader.root();
    EXPECT_EQ(root.file("own").stated_in, "x.toml");
    const StatedFile inherited = root.file("inherited");
    EXPECT_EQ(inherited.name, "b.txt");
    EXPECT_EQ(inherited.stated_in, "base.toml");
    EXPECT_EQ(both.reader.name(), "x.toml");
    EXPECT_EQ(without_blanks(both.json()), R"({"inherited":"x.tomlfrombase.toml:b.txt","own":"a.txt","text":"c.txt","wrong":1})");
    EXPECT_EQ(root.file("wrong").name, "");
    EXPECT_EQ(both.reader.error().message.view(), "x.toml:2: 'wrong' must be a text in quotes");
}

}  // namespace
}  // namespace tedavis::base::test_config_reader
