#include "bus/canaerospace/identification_service.hpp"

#include <gtest/gtest.h>

#include "tests/bus/golden_frames.hpp"

namespace tedavis::bus::test_identification_service {
namespace {

constexpr NodeSettings kNode{true, 30, 2, 7};

TEST(IdentificationService, AnswersARequestToThisNodeOrAll) {
    const IdentificationAnswer to_all = answer_identification(frame_of("080#00000000", 77), kNode);
    ASSERT_TRUE(to_all.due);
    EXPECT_EQ(text_of(to_all.frame), "081#1E10000002070000");
    EXPECT_EQ(to_all.frame.time.ns, 77);
    const IdentificationAnswer to_us = answer_identification(frame_of("080#1E000042"), kNode);
    ASSERT_TRUE(to_us.due);
    EXPECT_EQ(text_of(to_us.frame), "081#1E10004202070000");
    EXPECT_TRUE(answer_identification(frame_of("080#1E00000000000000"), kNode).due) << "padded to eight bytes";
}

TEST(IdentificationService, KeepsSilentOtherwise) {
    const char* others[] = {
        "080#1F000000",       // another node
        "080#1E020000",       // not NODATA
        "080#1E000100",       // another service
        "081#1E000000",       // a response
        "082#1E000000",       // another service channel
        "080#1E0000",         // too short
        "080#R4",             // remote frame
        "00010080#1E000000",  // redundancy channel 1
        "20000080#1E000000",  // error frame
        "080##01E000000",     // CAN FD
    };
    for (const char* other : others) EXPECT_FALSE(answer_identification(frame_of(other), kNode).due) << other;
    NodeSettings passive = kNode;
    passive.answer_identification = false;
    EXPECT_FALSE(answer_identification(frame_of("080#00000000"), passive).due);
}

}  // namespace
}  // namespace tedavis::bus::test_identification_service
