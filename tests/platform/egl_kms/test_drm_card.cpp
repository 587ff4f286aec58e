// What a card does is shown on an emulated one (tests/board); here is that a file that is no card ends in a sentence.
#include "platform/egl_kms/drm_card.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/platform/egl_kms/fake_seat.hpp"

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

/// A file that is no card: what follows the opening fails, and what was opened is given back.
TEST(DrmCard, AManagerThatGivesASeatOpensTheFile) {
    FakeManager manager;
    {
        DrmCard card;
        const base::Error error = card.open(no_card("/dev/dri/tedavis-absent"), {}, manager.port());
        EXPECT_NE(error.message.view().find("another program has the screen"), std::string_view::npos)
            << "the manager's file is no card, and the one that was named does not exist: " << error.message.c_str();
        EXPECT_EQ(card.seat_manager(), "seatd");
        EXPECT_EQ(card.descriptor(), manager.descriptor);
        manager.says = {FakeManager::Says::disable};
        EXPECT_EQ(card.take_terminal_request(), TerminalRequest::release);
        EXPECT_FALSE(card.become_master());
        card.drop_master();
        EXPECT_TRUE(card.answer_terminal(TerminalRequest::release));
        manager.is_gone = true;
        // libdrm takes this program for the master of whatever does not deny it, and pictures go on as long as it is.
        EXPECT_EQ(card.manager_end(), ManagerEnd::none);
        EXPECT_EQ(card.take_terminal_request(), TerminalRequest::none);
        EXPECT_EQ(card.manager_end(), ManagerEnd::left_the_card);
        // From now on the console asks, and it has not.
        EXPECT_FALSE(card.answer_terminal(TerminalRequest::release));
        card.drop_master();
        // The file lets nobody give it up, as a card that another process has opened.
        EXPECT_EQ(card.take_terminal_request(), TerminalRequest::lost);
        EXPECT_EQ(card.manager_end(), ManagerEnd::kept_the_card);
    }
    EXPECT_EQ(manager.calls, "open device:/dev/dri/tedavis-absent disable close:7 close ");
    EXPECT_LT(::fcntl(manager.descriptor, F_GETFD), 0) << "closed";
}

TEST(DrmCard, WithoutASeatTheProgramOpensTheFileItself) {
    FakeManager none, other;
    none.gives_seat = false;
    other.device_fault = EPERM;
    for (FakeManager* manager : {&none, &other}) {
        DrmCard card;
        const base::Error error = card.open(no_card("/dev/null"), {}, manager->port());
        EXPECT_NE(error.message.view().find("/dev/null (none): another program has the screen"), std::string_view::npos);
        EXPECT_EQ(card.seat_manager(), "");
        EXPECT_GE(card.descriptor(), 0);
        EXPECT_EQ(card.seat_fault(), manager->device_fault);
    }
    EXPECT_EQ(other.calls, "open device:/dev/null close ");
}

TEST(DrmCard, AScreenThatTheManagerDoesNotGiveMayComeLater) {
    constexpr base::Duration kShort = base::Duration::milliseconds(50), kNever = base::Duration::seconds(600);
    FakeManager elsewhere, still;
    elsewhere.says.clear();
    still.stands_still = true;
    {
        DrmCard card, other;
        EXPECT_EQ(card.open(no_card("/dev/null"), {}, elsewhere.port(), {kShort, kNever}).message.view(),
                  "/dev/null (none): seatd does not give this program the screen: another terminal or program has it; switch to "
                  "the terminal that was shown when the display started, or end the other program");
        EXPECT_TRUE(card.is_held());
        EXPECT_EQ(other.open(no_card("/dev/null"), {}, still.port(), {{}, kShort}).message.view(),
                  "/dev/null (none): the seat manager does not answer; start it again (`systemctl restart seatd`)");
        EXPECT_TRUE(other.is_held());
        EXPECT_LT(other.descriptor(), 0);
    }
    sem_post(&still.may_answer);
    sem_wait(&still.has_closed);
}

/// What the start says where the screen is taken away after the card was opened.
TEST(DrmCard, AScreenThatIsTakenAwayDuringTheStartMayComeLater) {
    DrmCard itself;
    EXPECT_TRUE(itself.open(no_card("/dev/null"), {}));
    const base::Error held = itself.refused_mode(DrmStatus::not_master);
    EXPECT_NE(held.message.view().find("/dev/null (none): another program has the screen"), std::string_view::npos);
    EXPECT_TRUE(itself.is_held());

    FakeManager manager;
    DrmCard managed;
    EXPECT_TRUE(managed.open(no_card("/dev/null"), {}, manager.port()));
    manager.says = {FakeManager::Says::disable};
    const base::Error elsewhere = managed.refused_mode(DrmStatus::not_master);
    EXPECT_NE(elsewhere.message.view().find("seatd does not give this program the screen"), std::string_view::npos)
        << elsewhere.message.c_str();
    EXPECT_TRUE(managed.is_held());
    const base::Error mode = managed.refused_mode(DrmStatus::failed);
    EXPECT_NE(mode.message.view().find("use another mode of [screen]"), std::string_view::npos);
    EXPECT_FALSE(managed.is_held()) << "a wrong setting";
}

/// Disabled while it opens: another terminal has the screen, and no desktop.
TEST(DrmCard, AManagerThatTakesTheScreenWhileItOpensIsSaid) {
    FakeManager manager;
    manager.disables_while_it_opens = true;
    DrmCard card;
    const base::Error error = card.open(no_card("/dev/null"), {}, manager.port());
    EXPECT_NE(error.message.view().find("seatd does not give this program the screen"), std::string_view::npos)
        << error.message.c_str();
    EXPECT_TRUE(card.is_held());
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
