// Logs of candump that went through can-utils' log2asc and asc2log, which know nothing of our reader. The tools replace
// the date by today's and mark every frame as received; error frames and lengths above 8 in classic frames they change
// (can-utils 2020.11), so that only data, remote and FD frames are compared.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "bus/candump/candump_log_source.hpp"
#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::bus::test_can_utils_round_trip {
namespace {

constexpr std::uint32_t kIds[] = {0x000, 0x001, 0x123, 0x7FF};
constexpr std::uint32_t kLongIds[] = {0x00000000, 0x00000123, 0x12345678, 0x1FFFFFFF};
constexpr int kFdLengths[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 20, 24, 32, 48, 64};

/// Every identifier width, kind, length and flag, on two interfaces, as candump -l writes them.
class LogText {
public:
    LogText() {
        for (const std::uint32_t id : kIds) add_all(id, "%03X");
        for (const std::uint32_t id : kLongIds) add_all(id, "%08X");
    }
    std::string text;
    std::size_t lines = 0;

private:
    void add_all(std::uint32_t id, const char* format) {
        char name[16];
        std::snprintf(name, sizeof name, format, id);
        for (int length = 0; length <= 8; ++length) {
            add(name + ("#" + bytes(length)));
            add(name + std::string("#R") + (length == 0 ? "" : std::to_string(length)));
        }
        for (const int length : kFdLengths)
            for (int flags = 0; flags < 4; ++flags) add(name + ("##" + std::to_string(flags) + bytes(length)));
    }
    std::string bytes(int count) {
        std::string digits;
        for (int i = 0; i < count; ++i) {
            char byte[4];
            std::snprintf(byte, sizeof byte, "%02X", static_cast<unsigned>(i * 29 + static_cast<int>(lines) * 7) & 0xFFu);
            digits += byte;
        }
        return digits;
    }
    /// Uneven gaps of some hundred microseconds.
    void add(const std::string& frame) {
        char stamp[32];
        std::snprintf(stamp, sizeof stamp, "(%d.%06d) can%d ", 1700000000 + microseconds_ / 1000000, microseconds_ % 1000000,
                      static_cast<int>(lines % 2));
        text += stamp + frame + "\n";
        microseconds_ += 131 + static_cast<int>(lines * 37 % 500);
        ++lines;
    }
    int microseconds_ = 0;
};

std::vector<CanFrame> frames_of(const std::string& text) {
    CandumpLogSource source(base::Span<const char>(text.data(), text.size()));
    std::vector<CanFrame> frames(20'000);
    frames.resize(source.read({std::numeric_limits<std::int64_t>::max()}, {frames.data(), frames.size()}));
    EXPECT_EQ(source.statistics().malformed, 0u);
    return frames;
}

std::string through_can_utils(const std::string& log, const std::string& options) {
    const test_support::TemporaryFolder folder;
    folder.write("in.log", log);
    const std::string convert = "cd " + folder.path() + " && log2asc " + options + " -I in.log -O a.asc can0 can1 2>/dev/null" +
                                " && asc2log -I a.asc -O out.log 2>/dev/null";
    EXPECT_EQ(std::system(convert.c_str()), 0) << "can-utils is missing; install the package can-utils";
    return folder.read("out.log");
}

TEST(CanUtilsRoundTrip, EveryFormOfFrameComesBack) {
    const LogText log;
    const std::vector<CanFrame> frames = frames_of(log.text);
    ASSERT_EQ(frames.size(), log.lines) << "each line is a frame before it travels";
    for (const char* options : {"", "-n"}) {  // -n: lines of the intermediate file end as on other systems
        const std::vector<CanFrame> back = frames_of(through_can_utils(log.text, options));
        ASSERT_EQ(back.size(), frames.size()) << options;
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const CanFrame &sent = frames[i], &got = back[i];
            ASSERT_EQ(got.id, sent.id) << i;
            ASSERT_EQ(got.extended, sent.extended) << i;
            ASSERT_EQ(got.kind, sent.kind) << i;
            ASSERT_EQ(got.length, sent.length) << i;
            ASSERT_EQ(got.fd_flags, sent.fd_flags) << i;
            ASSERT_EQ(got.channel, sent.channel) << i;
            ASSERT_EQ(got.data, sent.data) << i;
            const std::int64_t drift_ns = (got.time - back[0].time).ns - (sent.time - frames[0].time).ns;
            ASSERT_LE(std::abs(drift_ns), 1000) << i;
        }
    }
}

TEST(CanUtilsRoundTrip, AChangedByteIsSeen) {
    const LogText log;
    std::string back = through_can_utils(log.text, "");
    std::size_t at = 0;  // the frame of one byte: after the empty one and its remote frame
    for (int n = 0; n < 3; ++n) at = back.find(" 7FF#", at + 1);
    ASSERT_NE(at, std::string::npos);
    back[at + 5] = back[at + 5] == '0' ? '1' : '0';
    const std::vector<CanFrame> frames = frames_of(log.text), changed = frames_of(back);
    std::size_t different = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) different += frames[i].data != changed[i].data ? 1 : 0;
    EXPECT_EQ(different, 1u);
}

}  // namespace
}  // namespace tedavis::bus::test_can_utils_round_trip
