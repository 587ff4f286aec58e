#include "host_sim/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_temporary_folder {
namespace {

/// Sets TMPDIR for one test.
class TemporaryRoot {
public:
    explicit TemporaryRoot(const std::string& root) {
        if (const char* was = getenv("TMPDIR"); was != nullptr) was_ = was;
        setenv("TMPDIR", root.c_str(), 1);
    }
    ~TemporaryRoot() { was_.empty() ? unsetenv("TMPDIR") : setenv("TMPDIR", was_.c_str(), 1); }

private:
    std::string was_;
};

TEST(TemporaryFolder, GoesWithAllItsContent) {
    const test_support::TemporaryFolder place;
    const TemporaryRoot root(place.path());
    {
        const TemporaryFolder one, other;
        EXPECT_NE(one.path(), other.path());
        std::filesystem::create_directories(one.path() + "/inner");
        std::ofstream(one.path() + "/inner/file") << "x";
        EXPECT_EQ(place.entries(), 2u);
    }
    EXPECT_EQ(place.entries(), 0u);
}

TEST(TemporaryFolder, SaysWhereNoneCanBeMade) {
    const test_support::TemporaryFolder place;
    const TemporaryRoot root(place.file("none"));
    test_support::expect_user_error([] { const TemporaryFolder folder; }, "TMPDIR");
}

}  // namespace
}  // namespace tedavis::host_sim::test_temporary_folder
