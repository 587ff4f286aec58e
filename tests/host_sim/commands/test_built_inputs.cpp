#include "host_sim/commands/built_inputs.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_built_inputs {
namespace {

template <class Use>
void with_inputs(Use use) {
    const test_support::TemporaryFolder folder;
    test_support::run_command([&](Console& console) {
        BuiltInputs inputs(folder.path(), console);
        use(inputs);
        return 0;
    });
}

TEST(BuiltInputs, AreBuiltOnce) {
    with_inputs([](BuiltInputs& inputs) {
        FlightTest first, second;
        first.picture.terrain = second.picture.terrain = "jacksboro";
        inputs.resolve(first);
        const auto built = std::filesystem::last_write_time(first.picture.terrain);
        inputs.resolve(second);
        EXPECT_EQ(first.picture.terrain, second.picture.terrain);
        EXPECT_EQ(std::filesystem::last_write_time(second.picture.terrain), built);
    });
}

TEST(BuiltInputs, PathsStayAndUnknownNamesAreRefused) {
    with_inputs([](BuiltInputs& inputs) {
        FlightTest test;
        test.picture.terrain = "./a.tdb";
        inputs.resolve(test);
        EXPECT_EQ(test.picture.terrain, "./a.tdb");
        test.picture.terrain = "everest";
        test_support::expect_user_error([&] { inputs.resolve(test); }, "the shipped one is jacksboro");
    });
}

}  // namespace
}  // namespace tedavis::host_sim::test_built_inputs
