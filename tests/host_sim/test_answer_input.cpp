#include "host_sim/answer_input.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <istream>
#include <string>
#include <thread>

#include "host_sim/interrupt.hpp"

namespace tedavis::host_sim::test_answer_input {
namespace {

struct Pipe {
    int read_end = -1, write_end = -1;

    Pipe() {
        int ends[2] = {-1, -1};
        EXPECT_EQ(pipe(ends), 0);
        read_end = ends[0];
        write_end = ends[1];
    }
    ~Pipe() {
        close(read_end);
        end_input();
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void end_input() {
        if (write_end >= 0) close(write_end);
        write_end = -1;
    }
};

class AnswerInputOfAPipe : public ::testing::Test {
protected:
    void type(const std::string& text) const {
        EXPECT_EQ(write(pipe_.write_end, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    }
    std::string line() {
        std::string read;
        std::getline(typed_, read);
        return read;
    }
    Pipe pipe_;
    AnswerInput input_{pipe_.read_end};
    std::istream typed_{&input_};
};

TEST_F(AnswerInputOfAPipe, GivesTheLinesThatAreTyped) {
    const std::string longest(1000, 'n');
    type("yes\n\n" + longest + "\n");
    EXPECT_EQ(line(), "yes");
    EXPECT_EQ(line(), "");
    EXPECT_EQ(line(), longest) << "also one that its buffer does not hold";
    EXPECT_TRUE(typed_.good());
    type("no");
    pipe_.end_input();
    EXPECT_EQ(line(), "no");
    EXPECT_TRUE(typed_.eof());
}

TEST_F(AnswerInputOfAPipe, EndsWhereTheQuestionWasInterruptedBefore) {
    const InterruptGuard of_command;
    raise(SIGINT);
    type("yes\n");
    EXPECT_EQ(line(), "");
    EXPECT_TRUE(typed_.eof());
}

/// Whichever comes first, the signal or the wait; a read that begins anew after the signal would never end.
TEST_F(AnswerInputOfAPipe, EndsWhileItWaits) {
    const InterruptGuard of_command;
    std::thread presses([] { kill(getpid(), SIGINT); });
    EXPECT_EQ(line(), "");
    presses.join();
    EXPECT_TRUE(typed_.eof());
    EXPECT_TRUE(of_command.requested());
}

}  // namespace
}  // namespace tedavis::host_sim::test_answer_input
