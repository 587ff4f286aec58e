#include "target/new_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <filesystem>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::target::test_new_file {
namespace {

using ::testing::HasSubstr;

std::string message(const base::Error& error) { return std::string(error.message.view()); }

/// Files of this process end at so many bytes, as a full medium does.
class FullMedium {
public:
    explicit FullMedium(rlim_t bytes) : ignored_(signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        rlimit less = before_;
        less.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &less);
    }
    ~FullMedium() {
        setrlimit(RLIMIT_FSIZE, &before_);
        signal(SIGXFSZ, ignored_);
    }
    FullMedium(const FullMedium&) = delete;
    FullMedium& operator=(const FullMedium&) = delete;

private:
    rlimit before_{};
    void (*ignored_)(int);
};

struct NewFileTest : testing::Test {
    [[nodiscard]] bool has_part() const { return std::filesystem::exists(path + ".part"); }
    test_support::TemporaryFolder folder;
    std::string path = folder.file("c.toml");
};

TEST_F(NewFileTest, AppearsWholeAndReplacesWhatWasThere) {
    folder.write("c.toml", "earlier");
    NewFile file;
    ASSERT_EQ(message(file.open(path.c_str())), "");
    EXPECT_EQ(folder.read("c.toml"), "earlier");
    EXPECT_TRUE(has_part());
    ASSERT_EQ(message(file.write("later")), "");
    EXPECT_EQ(folder.read("c.toml"), "later");
    EXPECT_FALSE(has_part());
}

TEST_F(NewFileTest, WithoutATextNothingChanges) {
    folder.write("c.toml", "earlier");
    {
        NewFile file;
        ASSERT_EQ(message(file.open(path.c_str())), "");
    }
    EXPECT_EQ(folder.read("c.toml"), "earlier");
    EXPECT_FALSE(has_part());
}

TEST_F(NewFileTest, AFullMediumLeavesWhatWasThere) {
    folder.write("c.toml", "earlier");
    {
        NewFile file;
        ASSERT_EQ(message(file.open(path.c_str())), "");
        const FullMedium full(100);
        EXPECT_EQ(message(file.write(std::string(90, 'x'))), "") << "control: there is room for this";
    }
    folder.write("c.toml", "earlier");
    {
        NewFile file;
        ASSERT_EQ(message(file.open(path.c_str())), "");
        const FullMedium full(100);
        EXPECT_THAT(message(file.write(std::string(500, 'x'))), HasSubstr("c.toml: could not be written to its end ("));
    }
    EXPECT_EQ(folder.read("c.toml"), "earlier");
    EXPECT_FALSE(has_part());
}

TEST_F(NewFileTest, PlacesThatCannotBeWrittenAreSaid) {
    EXPECT_THAT(message(NewFile().open(folder.file("none/c.toml").c_str())),
                HasSubstr("none/c.toml: cannot be written (No such file or directory); check the folder and its permissions"));
    EXPECT_THAT(message(NewFile().open(folder.path().c_str())), HasSubstr(": is no regular file and would be replaced"));
    EXPECT_THAT(message(NewFile().open("/dev/null")), HasSubstr("/dev/null: is no regular file"));
    EXPECT_THAT(message(NewFile().open(std::string(1020, 'a').c_str())), HasSubstr("longer than 1018 bytes"));
}

}  // namespace
}  // namespace tedavis::target::test_new_file
