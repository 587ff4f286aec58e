#include "host_sim/flight_test/board_records.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/flight_test/fake_board_port.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_board_records {
namespace {

constexpr base::Duration kSecond = base::Duration::seconds(1);

class BoardRecordsTest : public ::testing::Test {
protected:
    test_support::FakeBoardPort board_{bus::BusSettings(), nullptr, 10};
    std::string display_ = "/run/records";
    bool is_stopped_ = false;
    std::function<bool()> is_interrupted_ = [this] { return is_stopped_; };
    BoardRecords records_{board_, display_, is_interrupted_};
};

TEST_F(BoardRecordsTest, ComeInTurn) {
    EXPECT_EQ(records_.next(board_.now() + kSecond)->frame, 0u);
    EXPECT_EQ(records_.next(board_.now() + kSecond)->frame, 1u);
    EXPECT_EQ(nlohmann::json::parse(records_.packet())["frame"], 1);
    EXPECT_FALSE(records_.next(board_.now())) << "none is there yet";
}

TEST_F(BoardRecordsTest, AMissingOneIsFound) {
    board_.drops_record = 1;
    static_cast<void>(records_.next(board_.now() + kSecond));
    test_support::expect_user_error([&] { static_cast<void>(records_.next(board_.now() + kSecond)); },
                                    "after frame 0 came the record of frame 2");
}

/// While logs were read, the socket ran full.
TEST_F(BoardRecordsTest, ThoseOfBeforeAreLeftOutAndMissingOnesAmongThemAreNoFault) {
    board_.pile_up(40, 26);
    BoardRecords records(board_, display_, is_interrupted_);
    std::optional<BoardRecord> record;
    int turns = 0;
    while (!record && ++turns < 100) record = records.next(board_.now() + kSecond);
    EXPECT_EQ(turns, 27);
    ASSERT_TRUE(record);
    EXPECT_EQ(record->frame, 40u);
}

TEST_F(BoardRecordsTest, AFrameThatIsNotOnTheScreenIsNone) {
    board_.dark_after = 0;
    require_on_screen(*records_.next(board_.now() + kSecond), display_);
    const std::optional<BoardRecord> dark = records_.next(board_.now() + kSecond);
    test_support::expect_user_error([&] { require_on_screen(*dark, display_); }, "/run/records: frame 1 is not on the screen");
}

TEST_F(BoardRecordsTest, SilenceIsBounded) {
    board_.silent_after = 0;
    EXPECT_FALSE(records_.next(board_.now() + kLongestWithoutRecord));
    EXPECT_THROW(static_cast<void>(records_.next(board_.now() + kSecond)), BoardLost);
}

TEST_F(BoardRecordsTest, CtrlCEnds) {
    is_stopped_ = true;
    EXPECT_THROW(static_cast<void>(records_.next(board_.now() + kSecond)), Interrupted);
}

}  // namespace
}  // namespace tedavis::host_sim::test_board_records
