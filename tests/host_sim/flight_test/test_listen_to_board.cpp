#include "host_sim/flight_test/listen_to_board.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/host_sim/flight_test/fake_board_port.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_listen_to_board {
namespace {

bus::CanFrame pitch() {
    bus::CanFrame frame;
    frame.id = 311;
    frame.length = 8;
    const std::array<std::uint8_t, 8> data = {9, 2, 0, 0, 0x40, 0xA0, 0, 0};
    std::copy(data.begin(), data.end(), frame.data.begin());
    return frame;
}

TEST(ListenToBoard, HearsTheBusAndWhatIsShown) {
    test_support::FakeBoardPort board(bus::BusSettings(), nullptr, 10);
    board.other = pitch();
    FactTracks tracks({});
    const HeardFlight heard = listen_to_board(board, {"/s", 8, 5, {}, {}}, tracks);
    EXPECT_GE(heard.frames.size(), 80u);
    EXPECT_LE(heard.frames.size(), 83u);
    EXPECT_EQ(heard.frames[0].id, 311u);
    EXPECT_NEAR(static_cast<double>(heard.shown), 31, 1) << "5 s to 8 s";
    EXPECT_NEAR(tracks.first_s(), 5, 0.11);
    const auto spans = tracks.spans();
    EXPECT_TRUE(std::any_of(spans.begin(), spans.end(), [](const FactSpan& span) {
        return span.fact.kind == FactKind::signal && span.fact.name == "pitch" && span.fact.value == "valid";
    }));
}

/// A script must not expect anything behind the end of its log.
TEST(ListenToBoard, NothingIsTakenBehindTheLastFrameOfTheBus) {
    test_support::FakeBoardPort board(bus::BusSettings(), nullptr, 10);
    board.other = pitch();
    board.bus_lasts = base::Duration::seconds(7);
    FactTracks tracks({});
    const HeardFlight heard = listen_to_board(board, {"/s", 20, 5, {}, {}}, tracks);
    const double end_s = (heard.frames.back().time - heard.frames.front().time).to_seconds();
    EXPECT_NEAR(end_s, 7, 0.11);
    EXPECT_LE(tracks.last_s(), end_s);
    EXPECT_NEAR(tracks.last_s(), end_s, 0.11);
}

TEST(ListenToBoard, ALogThatIsNotWholeIsRefused) {
    test_support::FakeBoardPort board(bus::BusSettings(), nullptr, 10);
    board.other = pitch();
    board.dropped = 3;
    FactTracks tracks({});
    EXPECT_GT(listen_to_board(board, {"/s", 8, 5, {}, {}}, tracks).shown, 0u) << "they were dropped before";
    ListenSettings settings{"/s", 8, 5, {}, {}};
    settings.told = [&board](double time_s) { board.dropped = time_s > 6 ? 5 : 3; };
    test_support::expect_user_error([&] { static_cast<void>(listen_to_board(board, settings, tracks)); },
                                    "/s: the kernel has dropped 2 frames of the bus");
}

TEST(ListenToBoard, AScreenThatShowsNothingIsRefused) {
    FactTracks tracks({});
    test_support::FakeBoardPort dark(bus::BusSettings(), nullptr, 10);
    dark.other = pitch();
    dark.dark_after = 60;
    test_support::expect_user_error(
        [&] {
            static_cast<void>(listen_to_board(dark, {"/s", 8, 5, {}, {}}, tracks));
        },
        "/s: frame 61 is not on the screen");
}

TEST(ListenToBoard, ASilentBusAndAThrownPanelAreRefused) {
    FactTracks tracks({});
    test_support::FakeBoardPort silent(bus::BusSettings(), nullptr, 10);
    test_support::expect_user_error(
        [&] {
            static_cast<void>(listen_to_board(silent, {"/s", 8, 5, {}, {}}, tracks));
        },
        "/s: the bus of this display says nothing");
    test_support::FakeBoardPort thrown(bus::BusSettings(), nullptr, 10);
    thrown.other = pitch();
    auto json = nlohmann::json::parse(*thrown.next_record(thrown.now()));
    json["phase_source"] = "switch";
    json["frame"] = 1;
    thrown.says = {"", json.dump()};
    test_support::expect_user_error(
        [&] {
            static_cast<void>(listen_to_board(thrown, {"/s", 8, 5, {}, {}}, tracks));
        },
        "/s: the panel states the phase");
}

}  // namespace
}  // namespace tedavis::host_sim::test_listen_to_board
