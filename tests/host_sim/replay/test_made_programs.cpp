#include "host_sim/replay/made_programs.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_made_programs {
namespace {

TEST(MadePrograms, KeepsWhatWasWrittenToTheRoomUnderItsKey) {
    MadePrograms programs;
    for (unsigned char n : {1, 2}) {
        const base::Span<unsigned char> room = programs.room(8);
        ASSERT_EQ(room.size(), 8u);
        room[0] = n;
        EXPECT_TRUE(programs.keep(n, "terrain", {n + 10u, room.subspan(0, n)}));
    }
    base::StoredProgram program;
    ASSERT_TRUE(programs.find(2, program));
    EXPECT_EQ(program.format, 12u);
    ASSERT_EQ(program.binary.size(), 2u);
    EXPECT_EQ(program.binary[0], 2);
    EXPECT_TRUE(programs.find(1, program));
    EXPECT_EQ(program.binary[0], 1) << "the room's next use does not change what was kept";
    EXPECT_FALSE(programs.find(3, program));
    EXPECT_EQ(programs.all().size(), 2u);
    EXPECT_EQ(programs.all().at(1).name, "terrain");
}

}  // namespace
}  // namespace tedavis::host_sim::test_made_programs
