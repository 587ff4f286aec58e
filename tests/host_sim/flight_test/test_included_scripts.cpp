#include "host_sim/flight_test/included_scripts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_included_scripts {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Included : public ::testing::Test {
protected:
    IncludedScripts read(const std::string& name, const ScriptParameters& stated = {}) {
        return read_included_scripts(place_.file(name), stated, faults_);
    }
    double value_of(const IncludedScripts& scripts, std::size_t file) { return scripts.files[file].find("v")->number; }
    test_support::TemporaryFolder place_;
    ScriptFaults faults_;
};

TEST_F(Included, ParametersOfTheIncludingFileAndTheCommandLineComeFirst) {
    place_.write("base.toml", "v = \"$p\"\n[parameters]\np = 1\n");
    place_.write("a.toml", "include = [\"base.toml\"]\nv = \"$p\"\n[parameters]\np = 2\n");
    EXPECT_EQ(value_of(read("base.toml"), 0), 1);
    const IncludedScripts both = read("a.toml");
    ASSERT_EQ(both.files.size(), 2u);
    EXPECT_THAT(both.paths[0], HasSubstr("base.toml")) << "the included one comes first";
    EXPECT_EQ(value_of(both, 0), 2);
    EXPECT_EQ(value_of(read("a.toml", {{"p", stated_parameter("3")}}), 0), 3);
    EXPECT_THAT(faults_.sentences(), IsEmpty());
}

TEST_F(Included, ParametersOfAnIncludedFileMayBeForOthers) {
    place_.write("base.toml", "[parameters]\np = 1\n");
    place_.write("a.toml", "include = [\"base.toml\"]\n");
    static_cast<void>(read("a.toml"));
    EXPECT_THAT(faults_.sentences(), IsEmpty());
}

TEST_F(Included, AFileIsTakenOnce) {
    place_.write("d.toml", "");
    place_.write("b.toml", "include = [\"d.toml\"]\n");
    place_.write("c.toml", "include = \"d.toml\"\n");
    place_.write("a.toml", "include = [\"b.toml\", \"c.toml\"]\n");
    EXPECT_EQ(read("a.toml").files.size(), 4u);
}

TEST_F(Included, ACircleIsAFault) {
    place_.write("a.toml", "include = [\"b.toml\"]\n");
    place_.write("b.toml", "\ninclude = [\"a.toml\"]\n");
    static_cast<void>(read("a.toml"));
    EXPECT_THAT(faults_.sentences(), ElementsAre(HasSubstr("b.toml:2: 'include': ")));
}

TEST_F(Included, MissingFilesAndParametersAreFaults) {
    place_.write("a.toml", "include = [\"no.toml\"]\n[parameters]\np = [1]\nq = 1\n");
    EXPECT_THAT(read("a.toml").parameters, ElementsAre("q"));
    EXPECT_THAT(faults_.sentences(), ElementsAre(HasSubstr("a.toml:1: 'include': "), HasSubstr("a.toml:3: 'p': a parameter is"),
                                                 HasSubstr("a.toml:4: nothing uses the parameter 'q'")));
    test_support::expect_user_error([&] { static_cast<void>(read("nothing.toml")); }, "nothing.toml");
}

}  // namespace
}  // namespace tedavis::host_sim::test_included_scripts
