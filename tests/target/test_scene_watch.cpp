#include "target/scene_watch.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <thread>
#include <vector>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::target::test_scene_watch {
namespace {

bool comes_true(const std::function<bool()>& condition) {
    for (int n = 0; n < 2000; ++n) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return false;
}

class SceneWatchTest : public ::testing::Test {
protected:
    /// A finished file is renamed into place, as the scene builder does.
    void put(std::uint64_t revision) {
        host_sim::SceneDraft draft = test_support::small_scene();
        draft.revision = revision;
        put(host_sim::sdb_bytes(draft));
    }
    void put(const std::vector<std::uint8_t>& bytes) {
        const std::string part = folder_.write("part", std::string(bytes.begin(), bytes.end()));
        std::filesystem::rename(part, path_);
    }
    bool start(std::uint64_t shown) { return watch_.start(path_.c_str(), rooms_[0], shown, 2); }
    bool has_loaded(std::uint64_t revision) {
        return comes_true([&] { return watch_.loaded() != nullptr && watch_.loaded()->header().revision == revision; });
    }

    test_support::TemporaryFolder folder_;
    const std::string path_ = folder_.file("x.sdb");
    std::vector<unsigned char> blocks_[2] = {std::vector<unsigned char>(1 << 16), std::vector<unsigned char>(1 << 16)};
    base::Arena rooms_[2] = {{blocks_[0].data(), blocks_[0].size()}, {blocks_[1].data(), blocks_[1].size()}};
    SceneWatch watch_;
};

TEST_F(SceneWatchTest, ASceneMayComeLaterAndBeFollowedByNewerOnes) {
    ASSERT_TRUE(start(0));
    EXPECT_EQ(watch_.loaded(), nullptr);
    base::FixedString<383> said;
    ASSERT_TRUE(comes_true([&] { return !(said = watch_.take_fault()).empty(); }));
    EXPECT_EQ(std::string(said.view()), path_ + ": is not there yet; there are no data until a sound scene is in its place");
    put(3);
    ASSERT_TRUE(has_loaded(3));
    EXPECT_TRUE(watch_.take_fault().empty());
    EXPECT_EQ(watch_.loaded()->layers().size(), 4u);
    put(4);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(watch_.loaded()->header().revision, 3u) << "it stays until it is taken over";
    watch_.go_on(rooms_[1], 3);
    EXPECT_TRUE(has_loaded(4));
}

TEST_F(SceneWatchTest, AnOlderOneIsNotTakenBack) {
    put(5);
    ASSERT_TRUE(start(5));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    put(4);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(watch_.loaded(), nullptr);
    put(6);
    EXPECT_TRUE(has_loaded(6));
}

TEST_F(SceneWatchTest, WhatIsNotSoundIsSaidOnce) {
    put(std::vector<std::uint8_t>(400, 'x'));
    ASSERT_TRUE(start(0));
    base::FixedString<383> fault;
    ASSERT_TRUE(comes_true([&] { return !(fault = watch_.take_fault()).empty(); }));
    EXPECT_EQ(std::string(fault.view()).rfind(path_ + ": is not a scene database", 0), 0u) << fault.view();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_TRUE(watch_.take_fault().empty());
    EXPECT_EQ(watch_.loaded(), nullptr);
    put(1);
    EXPECT_TRUE(has_loaded(1)) << "and the next one counts";
}

TEST_F(SceneWatchTest, StoppingTwiceAndWithoutAStartIsFine) {
    watch_.stop();
    ASSERT_TRUE(start(0));
    watch_.stop();
    watch_.stop();
}

}  // namespace
}  // namespace tedavis::target::test_scene_watch
