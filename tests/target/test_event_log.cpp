#include "target/event_log.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tedavis::target::test_event_log {
namespace {

TEST(EventLog, WritesOneLineAnEvent) {
    std::vector<std::string> lines;
    const EventLog log([](void* out, std::string_view line) { static_cast<std::vector<std::string>*>(out)->emplace_back(line); },
                       &lines);
    log.write({"CAN interface '", "can0", "': receiving"});
    log.write({});
    EXPECT_EQ(lines, (std::vector<std::string>{"tedavis-display: CAN interface 'can0': receiving\n", "tedavis-display: \n"}));
}

TEST(EventLog, CutsWhatIsTooLongButKeepsTheNewline) {
    std::string line;
    const EventLog log([](void* out, std::string_view text) { *static_cast<std::string*>(out) = text; }, &line);
    log.write({std::string(5000, 'x')});
    EXPECT_EQ(line.size(), 2047u);
    EXPECT_EQ(line.substr(line.size() - 2), "x\n");
}

TEST(EventLog, GoesToStderrByItself) {
    testing::internal::CaptureStderr();
    EventLog().write({"hello"});
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "tedavis-display: hello\n");
}

}  // namespace
}  // namespace tedavis::target::test_event_log
