#include "bus/candump/candump_log_writer.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "bus/candump/candump_log_source.hpp"

namespace tedavis::bus::test_candump_log_writer {
namespace {

class StringSink final : public TextSink {
public:
    explicit StringSink(std::size_t room = 1u << 20) : room_(room) {}
    [[nodiscard]] bool write(const char* text, std::size_t count) override {
        if (text_.size() + count > room_) return false;
        text_.append(text, count);
        return true;
    }
    std::string text_;

private:
    std::size_t room_;
};

CanFrame data_frame(std::uint32_t id, std::uint8_t length, std::int64_t ns) {
    CanFrame frame;
    frame.id = id;
    frame.extended = id > 0x7FF;
    frame.length = length;
    frame.time.ns = ns;
    for (std::size_t i = 0; i < length; ++i) frame.data[i] = static_cast<std::uint8_t>(17 * i + id);
    return frame;
}

TEST(CandumpLogWriter, WritesLinesByChannelName) {
    StringSink sink;
    constexpr std::string_view kNames[] = {"can0", "vcan7"};
    CandumpLogWriter writer(sink, kNames, StampDigits::micro, false);
    CanFrame frame = data_frame(0x123, 1, 1'500'000'000);
    EXPECT_TRUE(writer.write(frame));
    frame.channel = 1;
    EXPECT_TRUE(writer.write(frame));
    frame.channel = 2;
    EXPECT_FALSE(writer.write(frame));
    EXPECT_EQ(sink.text_, "(0000000001.500000) can0 123#23\n(0000000001.500000) vcan7 123#23\n");
    EXPECT_EQ(writer.written(), 2u);
    EXPECT_EQ(writer.refused(), 1u);
}

TEST(CandumpLogWriter, AFullSinkIsCounted) {
    StringSink sink(40);
    constexpr std::string_view kNames[] = {"can0"};
    CandumpLogWriter writer(sink, kNames, StampDigits::micro, false);
    EXPECT_TRUE(writer.write(data_frame(0x123, 1, 0)));
    EXPECT_FALSE(writer.write(data_frame(0x123, 1, 0)));
    EXPECT_EQ(writer.refused(), 1u);
}

std::vector<CanFrame> mixed_frames() {
    constexpr std::uint8_t kFdLengths[] = {0, 5, 8, 12, 16, 20, 24, 32, 48, 64};
    std::vector<CanFrame> frames;
    for (int i = 0; i < 300; ++i) {
        const std::uint32_t id =
            i % 2 == 0 ? 0x100u + static_cast<std::uint32_t>(i) : 0x10000u * 3u + static_cast<std::uint32_t>(i);
        CanFrame frame = data_frame(id, static_cast<std::uint8_t>(i % 9), 1'700'000'000'000'000'000 + i * 1'234'000ll);
        if (i % 5 == 3) {
            frame.kind = FrameKind::remote;
            frame.data = {};
        }
        if (i % 5 == 4) {
            frame = data_frame(id, kFdLengths[i / 5 % 10], frame.time.ns);
            frame.kind = FrameKind::fd;
            frame.fd_flags = static_cast<std::uint8_t>(i % 4);
        }
        frames.push_back(frame);
    }
    return frames;
}

/// Through can-utils' own converters, an independent reader and writer. They lose the date and add ` R`; identifiers,
/// data and flags must come back.
TEST(CandumpLogWriter, CanUtilsReadsWhatWeWriteAndWeReadWhatItWrites) {
    if (std::system("command -v log2asc > /dev/null && command -v asc2log > /dev/null") != 0)
        GTEST_FAIL() << "can-utils is missing; install the package can-utils";
    StringSink sink;
    constexpr std::string_view kNames[] = {"can0"};
    CandumpLogWriter writer(sink, kNames, StampDigits::micro, false);
    const std::vector<CanFrame> frames = mixed_frames();
    for (const CanFrame& frame : frames) ASSERT_TRUE(writer.write(frame));
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "tedavis_can_utils";
    std::filesystem::create_directories(folder);
    const std::string base = (folder / "mixed").string();
    std::ofstream(base + ".log") << sink.text_;
    const std::string convert = "log2asc -I " + base + ".log -O " + base + ".asc can0 2>/dev/null && asc2log -I " + base +
                                ".asc -O " + base + ".back 2>/dev/null";
    ASSERT_EQ(std::system(convert.c_str()), 0);
    std::ifstream file(base + ".back");
    std::ostringstream read;
    read << file.rdbuf();
    const std::string text = read.str();
    CandumpLogSource source(base::Span<const char>(text.data(), text.size()));
    std::vector<CanFrame> back(frames.size() + 1);
    const std::size_t count = source.read({std::numeric_limits<std::int64_t>::max()}, {back.data(), back.size()});
    ASSERT_EQ(count, frames.size());
    EXPECT_EQ(source.statistics().malformed, 0u);
    for (std::size_t i = 0; i < count; ++i) {
        ASSERT_EQ(back[i].id, frames[i].id) << i;
        ASSERT_EQ(back[i].extended, frames[i].extended) << i;
        ASSERT_EQ(back[i].kind, frames[i].kind) << i;
        ASSERT_EQ(back[i].length, frames[i].length) << i;
        ASSERT_EQ(back[i].fd_flags, frames[i].fd_flags) << i;
        ASSERT_EQ(back[i].data, frames[i].data) << i;
        const std::int64_t difference = (back[i].time - back[0].time).ns - (frames[i].time - frames[0].time).ns;
        ASSERT_LE(std::abs(difference), 1000) << i;
    }
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace tedavis::bus::test_candump_log_writer
