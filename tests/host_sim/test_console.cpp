#include "host_sim/console.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace tedavis::host_sim::test_console {
namespace {

TEST(Console, ChoosesTextOrJson) {
    std::ostringstream results, notes;
    Console(results, notes, false, false).result("words", "{}");
    EXPECT_EQ(results.str(), "words\n");
    results.str("");
    Console(results, notes, true, false).result("words", "{}");
    EXPECT_EQ(results.str(), "{}\n");
    EXPECT_EQ(notes.str(), "");
}

TEST(Console, APartOfACommandKeepsItsResultToItself) {
    std::ostringstream results, notes;
    const Console console(results, notes, true, true);
    Console part = console.without_result();
    part.result("text", "{}");
    part.note("a note");
    part.progress("terrain", 1, 2);
    EXPECT_EQ(results.str(), "");
    EXPECT_EQ(notes.str(), "a note\n\rterrain 50 %");
}

TEST(Console, DrawsProgressOnATerminalOnly) {
    std::ostringstream results, notes;
    Console quiet(results, notes, false, false);
    quiet.progress("work", 1, 2);
    quiet.progress_done();
    EXPECT_EQ(notes.str(), "");
    Console live(results, notes, false, true);
    live.progress("work", 1, 2);
    live.progress("work", 501, 1000);  // still 50 %
    live.note("done");
    EXPECT_EQ(notes.str(), "\rwork 50 %\ndone\n");
}

TEST(Console, AnotherPieceOfWorkBeginsAnew) {
    std::ostringstream results, notes;
    Console live(results, notes, false, true);
    live.progress("longer work", 1, 2);
    live.progress("work", 1, 2);
    live.progress_done();
    EXPECT_EQ(notes.str(), "\rlonger work 50 %\rwork 50 %       \n") << "spaces cover the longer line";
}

TEST(Console, SaysLinesOfProgressWhereItCannotRedraw) {
    std::ostringstream results, notes;
    Console piped(results, notes, false, false);
    piped.progress("work", 1, 4);
    piped.progress("work", 2, 4);
    EXPECT_EQ(notes.str(), "") << "some seconds have to pass";
    piped.set_between_lines(std::chrono::milliseconds(0));
    piped.progress("work", 3, 4);
    piped.progress_done();
    EXPECT_EQ(notes.str(), "work 75 %\n");
}

TEST(Console, AsksWhereSomebodyCanAnswer) {
    std::ostringstream results, notes;
    Console console(results, notes, false, true);
    EXPECT_FALSE(console.confirm("sure?").has_value());
    EXPECT_EQ(notes.str(), "") << "there is nobody to ask";
    for (const auto& [typed, is_yes] :
         {std::pair<const char*, bool>{"y\n", true}, {"Yes\n", true}, {"n\n", false}, {"\n", false}, {"", false}}) {
        std::istringstream answers(typed);
        console.set_answers(&answers);
        EXPECT_EQ(console.confirm("sure?"), is_yes) << typed;
    }
    EXPECT_EQ(notes.str().substr(0, 12), "sure? [y/N] ");
    EXPECT_EQ(notes.str().back(), '\n') << "what follows a question without an answer has a line of its own";
}

TEST(Console, SurvivesATotalOfZero) {
    std::ostringstream results, notes;
    Console live(results, notes, false, true);
    live.progress("work", 0, 0);
    EXPECT_EQ(notes.str(), "");
}

}  // namespace
}  // namespace tedavis::host_sim::test_console
