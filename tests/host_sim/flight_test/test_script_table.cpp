#include "host_sim/flight_test/script_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedavis::host_sim::test_script_table {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ScriptTables : public ::testing::Test {
protected:
    ScriptTable table(const char* text) {
        tree_ = parse_script_value(text, "f.toml", faults_);
        return ScriptTable(tree_, faults_);
    }
    ScriptValue tree_;
    ScriptFaults faults_;
};

TEST_F(ScriptTables, ReadsItsKeys) {
    ScriptTable all = table("n = 2\nt = \"x\"\nb = true\nl = [\"p\", \"q\"]\n[[s]]\na = 1\n[[s]]\na = 2\n[e]\nk = 3\n");
    EXPECT_EQ(all.number("n", 0, 5), 2.0);
    EXPECT_EQ(all.text("t"), "x");
    EXPECT_EQ(all.boolean("b"), true);
    EXPECT_THAT(all.texts("l"), ElementsAre("p", "q"));
    EXPECT_THAT(all.texts("t"), ElementsAre("x")) << "one text is a list of one";
    EXPECT_EQ(all.tables("s").size(), 2u);
    EXPECT_EQ(all.entries("e").front()->first, "k");
    all.finish();
    EXPECT_THAT(faults_.sentences(), IsEmpty());
}

TEST_F(ScriptTables, AnAbsentKeyIsNothing) {
    ScriptTable empty = table("");
    EXPECT_FALSE(empty.number("n", 0, 1));
    EXPECT_FALSE(empty.text("t"));
    EXPECT_THAT(empty.texts("l"), IsEmpty());
    EXPECT_THAT(faults_.sentences(), IsEmpty());
}

TEST_F(ScriptTables, AllFaultsAreCollected) {
    ScriptTable all = table("n = 7\nt = 3\nb = \"x\"\nl = [1]\nother = 1\n");
    static_cast<void>(all.number("n", 0, 5));
    static_cast<void>(all.text("t"));
    static_cast<void>(all.boolean("b"));
    static_cast<void>(all.texts("l"));
    all.finish();
    EXPECT_THAT(faults_.sentences(),
                ElementsAre("f.toml:1: 'n' must be 0 to 5", "f.toml:2: 't' must be a text", "f.toml:3: 'b' must be true or false",
                            "f.toml:4: 'l' must be a list of texts", HasSubstr("f.toml:5: unknown key 'other'")));
}

TEST_F(ScriptTables, NotANumberIsAFault) {
    ScriptTable all = table("n = nan\n");
    EXPECT_FALSE(all.number("n", 0, 5));
    EXPECT_EQ(faults_.count(), 1u);
}

TEST_F(ScriptTables, FindsAPlaceAmongNames) {
    ScriptTable all = table("k = \"b\"\n");
    EXPECT_EQ(place_among(all, "k", "b", {"a", "b"}), 1u);
    EXPECT_FALSE(place_among(all, "k", "c", {"a", "b"}));
    EXPECT_THAT(faults_.sentences(), ElementsAre("f.toml:1: 'k': there is no 'c'; say a or b"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_script_table
