#include "target/snapshot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>

#include "host_sim/png_file.hpp"
#include "render_core/gl/readback.hpp"
#include "target/display_application.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/target/fake_board.hpp"

namespace tedavis::target::test_snapshot {
namespace {

using ::testing::HasSubstr;

struct SnapshotTest : testing::Test {
    void SetUp() override { FakeClock::reset(); }

    /// Runs the application with a picture asked for before the frame `asked_at`.
    void run(std::uint64_t frames) {
        BoardPorts ports;
        ports.can = &port;
        ports.clocks = FakeClock::clocks();
        ports.log = lines.log();
        ports.snapshot = &snapshot;
        application = std::make_unique<DisplayApplication>(settings, std::move(ports));
        ASSERT_FALSE(application->start());
        ASSERT_FALSE(snapshot.start(path.c_str(), settings.width_px, settings.height_px));
        (void)application->run(frames, stop);
    }
    std::size_t pictures_written() const {
        const std::string said = lines.str(), sentence = "is the picture of this moment";
        std::size_t count = 0;
        for (std::size_t at = said.find(sentence); at != std::string::npos; at = said.find(sentence, at + 1)) ++count;
        return count;
    }

    test_support::TemporaryFolder folder;
    std::string path = folder.file("p.png");
    BoardSettings settings = board_settings();
    PairPort port;
    LogLines lines;
    EventLog log = lines.log();
    Snapshot snapshot{log};
    StopSignal stop;
    std::unique_ptr<DisplayApplication> application;
};

TEST_F(SnapshotTest, TheLastOfNFramesIsTheFile) {
    run(3);
    EXPECT_EQ(pictures_written(), 1u) << lines.str();
    const host_sim::RgbaPicture written = host_sim::read_png(path);
    ASSERT_EQ(written.width, settings.width_px);
    ASSERT_EQ(written.height, settings.height_px);
    std::vector<std::uint8_t> drawn(written.pixels.size());
    ASSERT_TRUE(gl::read_pixels(application->display().gl(), written.width, written.height, {drawn.data(), drawn.size()}));
    std::size_t wrong = 0;
    for (std::uint32_t row = 0; row < written.height; ++row)
        for (std::uint32_t n = 0; n < 4 * written.width; ++n)
            wrong += n % 4 != 3 && written.pixels[std::size_t{4} * written.width * row + n] !=
                                       drawn[std::size_t{4} * written.width * (written.height - 1 - row) + n]
                         ? 1
                         : 0;
    EXPECT_EQ(wrong, 0u);
}

TEST_F(SnapshotTest, ASignalAsksForTheNextFrame) {
    FakeClock::on_sleep = [] {
        static int sleeps = 0;
        if (++sleeps == 2) raise(SIGUSR1);
        if (sleeps == 5) raise(SIGTERM);
    };
    run(0);
    EXPECT_EQ(pictures_written(), 1u) << "once, although the run went on";
    EXPECT_TRUE(std::filesystem::exists(path));
}

TEST_F(SnapshotTest, WhereNothingCanBeWrittenTheStartSaysSo) {
    EXPECT_THAT(std::string(snapshot.start("/nowhere/p.png", 16, 16).message.view()),
                HasSubstr("/nowhere/p.png: cannot be written"));
    EXPECT_FALSE(snapshot.is_started());
    const std::string as_folder = folder.path();
    EXPECT_THAT(std::string(snapshot.start(as_folder.c_str(), 16, 16).message.view()), HasSubstr("is no regular file"));
}

TEST_F(SnapshotTest, TheSignalIsGivenBack) {
    struct sigaction before {
    }, after{};
    sigaction(SIGUSR1, nullptr, &before);
    {
        Snapshot other(log);
        ASSERT_FALSE(other.start(path.c_str(), 16, 16));
        raise(SIGUSR1);
        EXPECT_TRUE(other.take_request());
        EXPECT_FALSE(other.take_request()) << "once a signal";
    }
    sigaction(SIGUSR1, nullptr, &after);
    EXPECT_EQ(before.sa_handler, after.sa_handler);
    EXPECT_FALSE(std::filesystem::exists(path)) << "the trial leaves nothing";
}

}  // namespace
}  // namespace tedavis::target::test_snapshot
