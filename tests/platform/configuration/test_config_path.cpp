#include "platform/configuration/config_path.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tedavis::platform::test_config_path {
namespace {

TEST(ConfigPath, IsFoundFromTheFolderOfTheFile) {
    EXPECT_EQ(path_beside("/etc/tedavis/board.toml", "a/b.toml").view(), "/etc/tedavis/a/b.toml");
    EXPECT_EQ(path_beside("/etc/tedavis/board.toml", "/srv/b.toml").view(), "/srv/b.toml");
    EXPECT_EQ(path_beside("board.toml", "b.toml").view(), "b.toml");
    EXPECT_EQ(path_beside("board.toml", "").view(), "");
    EXPECT_TRUE(path_beside("/a/board.toml", std::string(2000, 'x')).cut());
}

}  // namespace
}  // namespace tedavis::platform::test_config_path
