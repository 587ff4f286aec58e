// What a card does is shown on an emulated one (tests/board); here is that a file that is no card ends in a sentence.
#include "platform/egl_kms/drm_card.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tedavis::platform::test_drm_card {
namespace {

#if defined(TEDAVIS_HAVE_KMS)

ScreenCard no_card(const char* path) {
    ScreenCard card;
    card.path = path;
    card.driver = "none";
    EXPECT_TRUE(card.connectors.try_push_back(ScreenConnector()));
    return card;
}

TEST(DrmCard, ACardThatWentAwayDuringTheStartIsSaid) {
    DrmCard card;
    const base::Error error = card.open(no_card("/dev/dri/tedavis-absent"), {});
    EXPECT_EQ(error.message.view(),
              "/dev/dri/tedavis-absent (none): cannot be opened any more (No such file or directory); start again");
}

TEST(DrmCard, WithoutMasterRightsTheStartEnds) {
    DrmCard card;
    const base::Error error = card.open(no_card("/dev/null"), {});
    EXPECT_NE(error.message.view().find("/dev/null (none): another program has the screen"), std::string_view::npos)
        << error.message.c_str();
    EXPECT_FALSE(card.is_atomic());
}

TEST(DrmCard, AWaitForAFlipEndsInTime) {
    DrmCard card;  // polls no file: the wait is the limit
    FlipEvent event;
    const base::Time begun = card.now();
    EXPECT_FALSE(card.wait_flip(base::Duration::milliseconds(20), event));
    EXPECT_GE(card.now() - begun, base::Duration::milliseconds(19));
    EXPECT_FALSE(card.wait_flip({}, event));
}

TEST(DrmCard, WithoutACardEachCallFails) {
    DrmCard card;
    std::uint32_t id = 0;
    EXPECT_FALSE(card.become_master());
    EXPECT_FALSE(card.add_framebuffer({}, id));
    EXPECT_EQ(card.set_mode(1), DrmStatus::failed);
    EXPECT_EQ(card.queue_flip(1), DrmStatus::failed);
    EXPECT_FALSE(card.is_connected());
    EXPECT_EQ(card.take_terminal_request(), TerminalRequest::none);
    card.turn_off();
    card.drop_master();
    card.restore();
}

#endif

}  // namespace
}  // namespace tedavis::platform::test_drm_card
