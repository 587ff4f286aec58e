#include "target/record_socket.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <memory>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/target/record_reader.hpp"

namespace tedavis::target::test_record_socket {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

struct RecordSocketTest : testing::Test {
    [[nodiscard]] std::string start(RecordSocket& one) const { return std::string(one.start(Path(place)).message.view()); }

    test_support::TemporaryFolder folder;
    std::string place = folder.file("records");
    RecordSocket socket;
};

TEST_F(RecordSocketTest, WhoConnectsReadsFromTheNextRecordOn) {
    ASSERT_EQ(start(socket), "");
    EXPECT_FALSE(socket.has_readers());
    socket.send("nobody reads this");
    const RecordReader first(place);
    ASSERT_TRUE(first.is_connected());
    EXPECT_TRUE(socket.has_readers());
    socket.send("one");
    const RecordReader second(place);
    EXPECT_TRUE(socket.has_readers());
    socket.send("two");
    EXPECT_THAT(first.take_all(), ElementsAre("one", "two")) << "each in a packet of its own";
    EXPECT_THAT(second.take_all(), ElementsAre("two"));
}

TEST_F(RecordSocketTest, AReaderThatHasLeftIsForgotten) {
    ASSERT_EQ(start(socket), "");
    {
        const RecordReader reader(place);
        EXPECT_TRUE(socket.has_readers());
    }
    socket.send("one");
    EXPECT_FALSE(socket.has_readers());
}

TEST_F(RecordSocketTest, AReaderThatSleepsMissesRecordsAndTheDisplayGoesOn) {
    ASSERT_EQ(start(socket), "");
    const RecordReader sleeper(place);
    ASSERT_TRUE(socket.has_readers());
    const std::string record(8000, 'x');
    for (int n = 0; n < 200; ++n) socket.send(record);
    const std::size_t kept = sleeper.take_all().size();
    EXPECT_GT(kept, 5u);
    EXPECT_LT(kept, 200u) << "a queue without an end would be a leak";
    socket.send("awake");
    EXPECT_THAT(sleeper.take_all(), ElementsAre("awake"));
}

TEST_F(RecordSocketTest, AReaderThatNeverReadsLosesItsPlace) {
    ASSERT_EQ(start(socket), "");
    const RecordReader stuck(place);
    ASSERT_TRUE(socket.has_readers());
    const std::string record(8000, 'x');
    for (std::uint32_t n = 0; n < RecordSocket::kMaxMissed; ++n) socket.send(record);
    EXPECT_TRUE(socket.has_readers()) << "some of these were taken";
    for (std::uint32_t n = 0; n < RecordSocket::kMaxMissed; ++n) socket.send(record);
    EXPECT_FALSE(socket.has_readers());
}

TEST_F(RecordSocketTest, OneMoreThanThereIsRoomForIsTurnedAway) {
    ASSERT_EQ(start(socket), "");
    std::vector<std::unique_ptr<RecordReader>> readers;
    for (std::size_t n = 0; n < RecordSocket::kMaxReaders; ++n) readers.push_back(std::make_unique<RecordReader>(place));
    EXPECT_TRUE(socket.has_readers());
    const RecordReader further(place);
    EXPECT_TRUE(socket.has_readers());
    EXPECT_TRUE(further.is_turned_away());
    socket.send("one");
    for (const auto& reader : readers) EXPECT_THAT(reader->take_all(), SizeIs(1));
}

TEST_F(RecordSocketTest, IsForItsUserAndGroupAndGoesWithItsOwner) {
    {
        RecordSocket own;
        ASSERT_EQ(start(own), "");
        struct stat found {};
        ASSERT_EQ(::lstat(place.c_str(), &found), 0);
        EXPECT_EQ(found.st_mode & 0777u, 0660u);
    }
    struct stat found {};
    EXPECT_NE(::lstat(place.c_str(), &found), 0);
}

TEST_F(RecordSocketTest, ReplacesWhatAnEndedProgramHasLeft) {
    const int left = ::socket(AF_UNIX, SOCK_SEQPACKET, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path, place.c_str(), place.size());
    const void* const plain = &address;
    ASSERT_EQ(::bind(left, static_cast<const sockaddr*>(plain), sizeof address), 0);
    ::close(left);
    EXPECT_EQ(start(socket), "");
    EXPECT_TRUE(RecordReader(place).is_connected());
}

/// Of another kind, but alive.
TEST_F(RecordSocketTest, AnotherProgramsSocketIsLeftAlone) {
    for (const int kind : {SOCK_STREAM, SOCK_DGRAM}) {
        place = folder.file(kind == SOCK_STREAM ? "stream" : "datagrams");
        const int other = ::socket(AF_UNIX, kind, 0);
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::memcpy(address.sun_path, place.c_str(), place.size());
        const void* const plain = &address;
        ASSERT_EQ(::bind(other, static_cast<const sockaddr*>(plain), sizeof address), 0);
        if (kind == SOCK_STREAM) {
            ASSERT_EQ(::listen(other, 1), 0);
        }
        RecordSocket one;
        EXPECT_THAT(start(one), HasSubstr("is in use by another program")) << kind;
        struct stat found {};
        EXPECT_EQ(::lstat(place.c_str(), &found), 0) << kind;
        ::close(other);
    }
}

TEST_F(RecordSocketTest, WhatCannotBeMadeSaysWhy) {
    ASSERT_EQ(start(socket), "");
    RecordSocket second;
    EXPECT_THAT(start(second), HasSubstr("is in use by another program"));
    EXPECT_FALSE(second.is_started());
    EXPECT_TRUE(RecordReader(place).is_connected()) << "the first one is left alone";
    place = folder.write("file", "kept");
    EXPECT_THAT(start(second), HasSubstr("is a file of another kind"));
    EXPECT_EQ(folder.read("file"), "kept");
    place = folder.file("no/folder");
    EXPECT_THAT(start(second), HasSubstr("name a folder that exists"));
    place = folder.file(std::string(120, 'x'));
    EXPECT_THAT(start(second), HasSubstr("choose a shorter path"));
}

}  // namespace
}  // namespace tedavis::target::test_record_socket
